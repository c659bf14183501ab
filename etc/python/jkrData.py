# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Reading of the results of jkrImpact."""
from csvTables import summary, table


class Result:
    """The files of one case."""

    def __init__(self, case):
        self.folder = case + '/postProcessing/jkrImpact/'
        self.summary = summary(self.folder)

    def __getitem__(self, name):
        return self.summary[name]

    def table(self, name):
        return table(self.folder + name + '.csv')

    def trajectory(self, i):
        return self.table(f'trajectory_{i}')
