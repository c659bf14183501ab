# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""What the results and conclusions of four papers say, each statement with the
quantity that stands for it here and the two bounds within which it is met.

The quotes are in the language of the paper, with our translation. A comparative
("larger", "many times") has bounds as well: the lower one is what the word
must at least mean, or the scatter of the run; the upper one is what nothing
could exceed, or what would be another finding. A statement that this project
does not meet has a second pair of bounds, for our own value, and the reason:
its check fails when the value leaves them, and also when it comes to lie within
those of the paper.

The values come from the tutorials: checks.py.
"""

from collections import namedtuple

Statement = namedtuple(
    "Statement", "name section quote says quantity unit low high why tutorial"
    " ours reason", defaults=(None, ""))

PAPERS = {
    "scattering": "S. V. Panfilov and Yu. M. Tsirkunov, J. Appl. Mech. Tech."
    " Phys. 49(2), 2008, 222-230",
    "adhesion": "J. Xie, C. Li, Z. Zhu, H. Ma and R. Li, Chem. Ind. Eng. Prog."
    " 40(12), 2021",
    "cylinder": "D. L. Reviznikov and A. V. Sposobin, suspension over a"
    " cylinder, 2007",
    "plume": "Z. Li, Z. Li, J. Wu and A. Peng, J. Solid Rocket Technology"
    " 37(6), 2014, 797-803"}

STATEMENTS = []


def at(tutorial, *rows):
    """Statements of which one tutorial tells."""
    STATEMENTS.extend(Statement(*row[:9], tutorial, *row[9:]) for row in rows)


# ----------------------------------------------------------------- scattering

SMOOTH = (
   ("scattering.symmetric", "3",
    "пространственные индикатрисы оказались симметричными относительно"
    " плоскости OXY",
    "the spatial indicatrices are symmetric about OXY",
    "largest of the mean of beta2 and of chi squared of mirrored cells of I,"
    " of five shapes, in standard errors", "",
    0, 4, "four standard errors"),
   ("scattering.smoothShapesDiffer", "3, fig. 6a",
    "для эллипсоидальных и призматических частиц существенно различаются",
    "those of ellipsoids and prisms differ substantially",
    "least total variation between an ellipsoid and a prism", "",
    0.3, 1, "three times what nearly coincides in fig. 6b; 1: disjoint"),
   ("scattering.prismsScatterMore", "3, fig. 6a",
    "Призматические частицы значительно сильнее рассеиваются по углу",
    "prisms are scattered considerably more",
    "least deviation of alpha2 of a prism over the largest of an ellipsoid",
    "", 2, 7.8, "twice; 7.8: that of a uniform distribution"),
   ("scattering.prismsOtherAngle", "3, fig. 6a",
    "доминирующий угол их отскока значительно отличается от угла отскока"
    " сферических частиц",
    "their dominant angle is considerably another than the sphere's",
    "least distance of a prism's most probable angle from the sphere's",
    "deg", 5, 30, "five bins of 1 deg; 30: more than one deviation"))

at("scatteringIndicatrix/figure6a", *SMOOTH, *(
    (name + "OnLeaving", where, quote,
     says + " (bodies followed until they leave the wall)",
     quantity + "; on leaving the wall", *rest)
    for name, where, quote, says, quantity, *rest in SMOOTH))

at("scatteringIndicatrix/figure6b",
   ("scattering.symmetricRough", "3",
    "пространственные индикатрисы оказались симметричными относительно"
    " плоскости OXY",
    "the spatial indicatrices are symmetric about OXY, on the rough wall too",
    "largest of the mean of beta2 and of chi squared of mirrored cells of I,"
    " of five shapes, in standard errors", "",
    0, 4, "four standard errors"),
   ("scattering.roughnessChanges", "3, fig. 6b",
    "При отражении частиц от шероховатой поверхности индикатриса рассеяния"
    " существенно изменяется",
    "the rough wall changes the indicatrix substantially",
    "least total variation between smooth and rough wall, of six shapes", "",
    0.3, 1, "three times what nearly coincides; 1: disjoint"),
   ("scattering.roughShapesCoincide", "3, fig. 6b",
    "Индикатрисы частиц всех рассмотренных форм (а также сферических частиц)"
    " оказываются очень близкими",
    "those of all shapes and of spheres are very close",
    "largest total variation of a shape from the sphere", "",
    0, 0.1, "one particle in ten leaves elsewhere"),
   ("scattering.roughAngleLarger", "3, fig. 6b",
    "наиболее вероятный угол отскока частиц в плоскости OXY значительно"
    " больше",
    "the most probable angle is considerably larger than on the smooth wall",
    "least ratio of the most probable angles, rough over smooth", "",
    1.5, 6, "half as large again; 6: 100 deg"),
   ("scattering.roughSpreadLarger", "3, fig. 6b",
    "Больше также разброс значений угла",
    "the spread is larger too",
    "least ratio of the deviations, rough over smooth", "",
    1.05, 3, "ten standard errors; 3: that of a uniform distribution over"
    " that of prisms"),
   ("scattering.roughnessMostForEllipsoids", "3",
    "влияние шероховатости особенно велико для эллипсоидальных частиц",
    "roughness matters most for ellipsoids",
    "least total variation, smooth to rough, of an ellipsoid over the largest"
    " of a prism", "", 1.05, 3, "sampling changes it by 0.01; 3: what remains"
    " if prisms changed by a third"),
   ("scattering.roughnessLevels", "3 and summary",
    "шероховатость поверхности нивелирует влияние формы частиц",
    "roughness levels out the influence of the shape",
    "largest total variation between two shapes other than the sphere, smooth"
    " over rough", "", 3, 30, "three times; 30: sampling alone would be left"),
   ("scattering.severalImpacts", "1, fig. 3",
    "падающая частица ... может несколько раз столкнуться с шероховатым"
    " рельефом",
    "a particle may strike the relief several times",
    "largest mean number of impacts of the six shapes", "",
    1.05, 3, "one in twenty strikes again; 3: several for all"))

at("scatteringIndicatrix/sizeStudy",
   ("scattering.sizeMattersLittle", "3",
    "варьирование значений a в широком диапазоне ... практически не влияет на"
    " вид индикатрис",
    "the size has practically no influence while below the peak spacing",
    "largest total variation of a body of 16 to 64 um from 32 um", "",
    0, 0.1, "as for nearly coinciding curves"))

at("scatteringIndicatrix/measuredProfile",
   ("scattering.modelMatchesProfile", "2",
    "из условия наилучшего согласования рассеивающих свойств модельного и"
    " реального профилей",
    "parameters of the model give the best agreement of scattering with the"
    " profile",
    "total variation of the fitted model from the profile over that of the"
    " model that made it", "", 0.5, 1.2,
    "as near as the right parameters, but for sampling; below 0.5 the fit"
    " would follow the noise of this profile"))

# ------------------------------------------------------------------- adhesion

at("adhesion/polystyreneOnQuartz",
   ("adhesion.captureLatex", "1.3, fig. 4",
    "颗粒的临界捕集速度约为1.2m/s",
    "latex on quartz is captured below about 1.2 m/s",
    "speed of capture", "m/s", 1.15, 1.25, "the digits given"),
   ("adhesion.fitOfAlpha", "1.3, figs 3 and 9, 3(1)",
    "获得了参数α和法向恢复系数en的拟合关系式",
    "a fit of alpha to the restitution is found",
    "largest error of the restitution by a fitted alpha, 0.1 to 0.95, far above"
    " capture", "", 0, 0.005,
    "the source's coefficients are lost; Marshall's, of the same degree, err by"
    " 0.0011"),
   ("adhesion.measured", "1.3, fig. 4", "模型计算结果与实验数据的吻合度较好",
    "restitutions agree well with those that Dahneke measured",
    "restitution at 10 m/s that capture at 1.2 m/s leaves open, largest less"
    " least", "", 0, 0.05, "for the constants that survive to fix a curve that"
    " can be compared", (0.45, 0.52),
    "out of reach: his tables were not at hand, the figure and the coefficients"
    " of the fit are lost, and what survives, the speed of capture, leaves the"
    " restitution open (family.png of the tutorial, a scan); the tutorial fits"
    " and draws measured pairs once they are in constant/measured.csv"))

at("adhesion/silicaOnSteel",
   ("adhesion.lastContactPair", "2.1, fig. 12", "临界软卸载点S",
    "a pair comes apart at -0.386 nm", "overlap at S, pair", "nm",
    -0.3865, -0.3855, "the digits given"),
   ("adhesion.lastContactWall", "2.1", "始终不低于临界值-0.73nm",
    "a sphere comes off the wall at -0.73 nm", "overlap at S, wall", "nm",
    -0.735, -0.725, "the digits given"),
   ("adhesion.equilibrium", "2.1", "平衡位移值0.884nm",
    "equilibrium on the wall at 0.884 nm", "overlap at B, wall", "nm",
    0.8835, 0.8845, "the digits given"),
   ("adhesion.sticksToWall", "2.1, fig. 7", "在0.031m/s ... 发生黏附",
    "without damping a sphere sticks to the wall at 0.031 m/s, above it"
    " rebounds", "speed of capture, wall, undamped", "m/s",
    0.031, 0.0325, "sticks at 0.031; theory, rounded, 0.032"),
   ("adhesion.sticksToPair", "2.1, fig. 7", "和0.014m/s 时",
    "and to another sphere at 0.014 m/s",
    "speed of capture, pair, undamped", "m/s", 0.014, 0.015,
    "sticks at 0.014, and a digit above rebounds"),
   ("adhesion.theory", "2.1", "理论计算值0.032m/s",
    "theory: 0.032 m/s", "speed from the work of separation", "m/s",
    0.0315, 0.0325, "the digits given"),
   ("adhesion.numericalIsTheory", "2.1",
    "数值计算的临界捕集速度与理论值基本吻合",
    "the computed speeds of capture agree with theory",
    "largest deviation from 1 of computed over theoretical, wall and pair",
    "", 0, 0.03, "0.031 and 0.032 agree in the paper: 3 %"),
   ("adhesion.pairCapturedLess", "2.1",
    "颗粒与颗粒碰撞的临界捕集速度小于颗粒与壁面",
    "a pair is captured at less speed than a sphere on the wall",
    "ratio of the speeds of capture, damped, pair over wall", "",
    0.455, 0.462, "0.394 over 0.86 with their digits"),
   ("adhesion.wallHoldsMore", "2.1, table 4",
    "其黏附功会大于颗粒与颗粒之间的碰撞",
    "the work of adhesion is larger on the wall than between spheres",
    "work of separation, wall over pair", "", 2, 20,
    "twice; 20: 0.032 and 0.014 m/s give 9.5 with their digits"),
   ("adhesion.overlapGrows", "2.1, fig. 7",
    "最大接触位移随着入射速度的增加而增加",
    "the largest overlap grows with the speed",
    "exponent of the largest overlap in the speed, pair, undamped", "",
    0.4, 0.9, "Hertz: 0.8; less near capture"),
   ("adhesion.contactTimeFalls", "2.1, fig. 7",
    "随着入射速度的增加,碰撞过程的颗粒接触时间不断减小",
    "the time of contact falls with the speed",
    "exponent of the time of contact in the speed, pair, undamped", "",
    -1, -0.1, "Hertz: -0.2; more near capture"),
   ("adhesion.loopsPersist", "2.1, fig. 8",
    "当截断误差不存在时 ... 一直往复运动",
    "without error of truncation an undamped captured sphere goes on forever",
    "largest change of the speed over 50 loops, parts of it", "",
    0, 1e-3, "error of reading the passages from the table"),
   ("adhesion.captureWallDamped", "2.1",
    "临界捕集速度在0.86m/s附近",
    "with damping the wall captures below about 0.86 m/s",
    "speed of capture, wall, damped", "m/s", 0.855, 0.865,
    "the digits given"),
   ("adhesion.capturePairDamped", "2.1",
    "颗粒与颗粒碰撞的临界捕集速度为0.394m/s",
    "and a sphere below 0.394 m/s",
    "speed of capture, pair, damped", "m/s", 0.3935, 0.3945,
    "the digits given"),
   ("adhesion.dampingCaptures", "2.1 and 3(2)",
    "存在阻尼耗散时颗粒所需的临界捕集速度更大",
    "damping raises the speed of capture, far beyond theory",
    "speed of capture on the wall, damped over undamped", "",
    26.3, 27.5, "0.86 over 0.032 with their digits"),
   ("adhesion.settles", "2.1, fig. 11",
    "最终在平衡位置B点停止运动",
    "a damped captured sphere comes to rest at B",
    "largest distance of the last overlap from B", "nm", 0, 1e-3,
    "the digits given"))

at("adhesion/silicaLayer",
   ("adhesion.chainCapture", "2.1, 3(3)",
    "在0.394m/s 的入射速度以下,颗粒P1 会直接在接触面上黏附",
    "P1 is captured below 0.394 m/s", "P1 captured up to, one way", "m/s",
    0.3935, 0.3945, "the digits given"),
   ("adhesion.chainDetachment", "2.1, 3(3)",
    "当入射速度大于0.7m/s时,黏附颗粒P2将从壁面脱离",
    "P2 stays below 0.69 m/s and comes off above 0.7 m/s",
    "P2 detaches from, one way", "m/s", 0.69, 0.70, "the paper's interval",
    (0.7795, 0.7805), "the constants are rebuilt from the numbers that"
    " survive of the source; no one dissipation parameter for both contacts"
    " gives both speeds (one of the wall of 1.147 does), nor does the"
    " coupling by Newton's law, nor one law that falls with the restitution,"
    " which leaves the wall the parameter of its capture (0.780 m/s at"
    " least); one that falls with the speed, from 1.189 at 0.394 m/s to 1.130"
    " at 0.695 m/s, does (alphas.png of the tutorial)"),
   ("adhesion.chainOverlapGrows", "2.1, fig. 12",
    "且随着入射速度的增大,最大接触位移峰值增加",
    "the largest overlap of P1 grows with the speed",
    "exponent of the largest overlap of P1 in the speed", "",
    0.5, 1, "Hertz: 0.8; less near capture"),
   ("adhesion.chainTimeFalls", "2.1, fig. 12", "接触时间也随之减少",
    "and its time of contact falls",
    "exponent of the time of contact of P1 in the speed, of those that"
    " rebound", "", -1, -0.1, "Hertz: -0.2; more near capture"),
   ("adhesion.chainEnds", "2.1, fig. 13",
    "当颗粒运动结束时,该值不变",
    "P2, when it stays, ends where it began, at 0.884 nm",
    "largest distance of the last overlap of P2 from 0.884", "nm", 0, 1e-3,
    "the digits given"))

# ------------------------------------------------------------------- cylinder

at("rhoCentralParcelFoam/dustyCylinderMach6",
   ("cylinder.layerForms", "results, fig. 1",
    "Видно постепенное формирование ... зоны повышенной концентрации частиц"
    " вблизи обтекаемой поверхности",
    "a zone of raised concentration forms gradually near the surface",
    "5 um within 0.1 R and 60 deg: at the end over at 20 us", "",
    1.5, 50, "half as many again; 50: the whole stream would stay"),
   ("cylinder.spin", "model",
    "величина угловой скорости может достигать десятков и сотен тысяч радиан"
    " в секунду",
    "angular velocities reach tens and hundreds of thousands of rad/s",
    "median after the wall, 5 um", "rad/s", 1e4, 1e6,
    "ten thousand to a million", (1e6, 1e9),
    "the paper's own wall law leaves up to 2.5 f (1 + e) v/r, for 5 um and"
    " 400 m/s of the order of 1e8 rad/s, whatever f above 0.01 is meant"))

COLLISIONS = "rhoCentralParcelFoam/dustyCylinderMach6Collisions"
at(COLLISIONS,
   ("cylinder.collisionsRaiseConcentration", "results, fig. 2",
    "Учет взаимодействия частиц ... приводит к ... повышению концентрации"
    " примеси вблизи поверхности",
    "collisions raise the concentration near the surface",
    "5 um within 0.008 R and 30 deg at 1e-4, with collisions over without", "",
    1.1, 10, "a tenth; 10: all of the layer there"),
   ("cylinder.collisionsBlur", "results, fig. 2",
    "размыванию границы рассматриваемой",
    "collisions blur the boundary of that zone",
    "distance over which the concentration of 5 um within 30 deg falls from"
    " three quarters of its maximum to a quarter, in parts of the distance of"
    " the half from the wall, at 1e-4, with collisions over without", "",
    1.2, 20, "a fifth wider, more than its scatter of a tenth; 20: from a step"
    " to a tail over the whole shock layer"),
   ("cylinder.spinLittleInLayer", "results, fig. 2",
    "Вращение частиц способствует некоторому расширению зоны ... однако"
    " существенного вклада ... не вносит",
    "spin widens the zone a little and contributes nothing essential",
    "mean distance from the wall of 5 um within 0.1 R and 60 deg at 1e-4, with"
    " spin over without", "", 1, 1.2, "wider, by less than a fifth"),
   ("cylinder.impactsDouble", "results, fig. 3",
    "примерно к двукратному росту интенсивности ударов ... уже при объемной"
    " концентрации примеси 10^-5",
    "collisions about double the impacts already at 1e-5",
    "impacts of 5 um at 1e-5 within 10 deg of the stagnation line, where they"
    " are most, with collisions over without", "",
    1.7, 2.3, "about double"),
   ("cylinder.impactsDoubleAll", "results, fig. 3",
    "примерно к двукратному росту интенсивности ударов",
    "the same, read for the whole surface",
    "impacts of 5 um at 1e-5 on the whole surface, with collisions over"
    " without", "",
    1.7, 2.3, "about double", (1.3, 1.65),
    "the paper gives no constants of walls and pairs. The sweep of the tutorial"
    " (`./Allrun -walls`) shows that the wall decides: the less it gives back,"
    " the more impacts collisions add. The wall of the tutorial doubles them"
    " where most of them are; over the whole surface only one does that gives"
    " back a hundredth of the speed, and it has more than double near the"
    " stagnation line"),
   ("cylinder.impactsManyfold", "results, fig. 3",
    "Повышение концентрации до 10^-4 влечет многократное увеличение числа"
    " ударов",
    "1e-4 brings a many-fold increase of the number of impacts",
    "impacts of 5 um at 1e-4, with collisions over without", "",
    3, 30, "three-fold; 30: ten times as much again as doubled at 1e-5, and"
    " half more"),
   ("cylinder.normalSpeedFalls", "results, fig. 4",
    "значительное уменьшение средней нормальной скорости частицы в момент"
    " соударения с поверхностью",
    "the mean normal speed at impact falls considerably",
    "mean normal speed of 5 um at 1e-4, with collisions over without", "",
    0.05, 0.6, "by four tenths; 0.05: the threshold of counting is near"),
   ("cylinder.repeatedImpacts", "results",
    "наблюдаются повторные неоднократные удары частицы о поверхность со"
    " снижающимися скоростями",
    "particles strike again and again, slower each time",
    "impacts per first impact, 5 um at 1e-4 with collisions", "",
    2, 100, "twice at least; 100: many times"),
   ("cylinder.powerFalls", "results, fig. 5",
    "ослаблению теплового воздействия частиц на тело практически на всей"
    " поверхности",
    "collisions weaken the thermal action practically everywhere",
    "share of the struck surface where the power of 5 um at 1e-4 is less with"
    " collisions", "", 0.8, 1, "practically everywhere: four fifths"),
   ("cylinder.shielded", "results, fig. 5",
    "В особой мере это проявляется в окрестности передней критической точки",
    "most of all near the stagnation point",
    "power with collisions over without, within 10 deg over that of the whole"
    " surface, 5 um at 1e-4", "", 0.05, 1,
    "less; 0.05: nothing would arrive"),
   ("cylinder.spinWeakens", "results",
    "Учет вращения частиц вызывает дальнейшее ослабление теплового"
    " воздействия практически на всей поверхности",
    "spin weakens the thermal action further",
    "power of 5 um at 1e-4, with spin over without, both with collisions", "",
    0.5, 1, "less; 0.5: as much as collisions do"))

at("rhoCentralParcelFoam/dustyCylinderMach6Walls",
   ("cylinder.semiRelations", "model",
    "Параметры частицы после отскока от поверхности определяются"
    " соотношениями",
    "the semi-empirical relations give what a particle has after the rebound",
    "largest deviation of recorded rebounds from them, of velocity or r omega"
    " in parts of those on arrival", "", 0, 1e-8,
    "the ten digits of the mesh's corners"),
   ("cylinder.semiMechanics", "model",
    "В ее основе помимо законов механики лежит набор экспериментальных данных",
    "they rest on mechanics and on measured coefficients",
    "largest change of the angular momentum about the contact in a sliding"
    " rebound, over m r of the velocity and r omega on arrival", "", 0, 1e-8,
    "the ten digits of the mesh's corners"),
   *((f"cylinder.semi{name}", where, quote, says + " (semi-empirical wall)",
      quantity, "", low, high, why, *ours)
     for name, where, quote, says, quantity, low, high, why, *ours in (
       ("ImpactsDouble", "results, fig. 3",
        "примерно к двукратному росту интенсивности ударов",
        "collisions about double the impacts already at 1e-5",
        "impacts of 5 um at 1e-5 within 10 deg of the stagnation line, with"
        " collisions over without", 1.7, 2.3, "about double", (1.3, 1.7),
        "the paper gives no coefficients and does not say which wall its"
        " figures have. At angles of 20 to 60 deg these give back several"
        " times what the hard spheres do, and what is thrown further off"
        " strikes again less often. Other pairs do not help: only such as do"
        " not part at all make it double (`./Allrun -pairs`)"),
       ("ImpactsManyfold", "results, fig. 3",
        "Повышение концентрации до 10^-4 влечет многократное увеличение числа"
        " ударов", "1e-4 brings a many-fold increase of the number of impacts",
        "impacts of 5 um at 1e-4, with collisions over without",
        3, 30, "as with the hard-sphere wall"),
       ("NormalSpeedFalls", "results, fig. 4",
        "значительное уменьшение средней нормальной скорости",
        "the mean normal speed at impact falls considerably",
        "mean normal speed of 5 um at 1e-4, with collisions over without",
        0.05, 0.6, "as with the hard-sphere wall"),
       ("RepeatedImpacts", "results",
        "наблюдаются повторные неоднократные удары",
        "particles strike again and again",
        "impacts per first impact, 5 um at 1e-4 with collisions",
        2, 100, "as with the hard-sphere wall"),
       ("PowerFalls", "results, fig. 5",
        "ослаблению теплового воздействия частиц на тело практически на всей"
        " поверхности",
        "collisions weaken the thermal action practically everywhere",
        "share of the struck surface where the power of 5 um at 1e-4 is less"
        " with collisions", 0.8, 1, "as with the hard-sphere wall"),
       ("Shielded", "results, fig. 5",
        "В особой мере это проявляется в окрестности передней критической"
        " точки", "most of all near the stagnation point",
        "power with collisions over without, within 10 deg over that of the"
        " whole surface, 5 um at 1e-4", 0.05, 1,
        "as with the hard-sphere wall"))))

# ---------------------------------------------------------------------- plume

at("dsmcParcelFoam/twoPhaseChannel",
   ("plume.momentumOpposite", "3.1, fig. 2",
    "两者的梯度大小大致相等,符号相反",
    "the rates of momentum of gas and particles are about equal and opposite",
    "of the gas over of the spheres, all slabs", "", -1.03, -0.97,
    "3 %: four standard deviations, if a slab has 5 %"),
   ("plume.energyOpposite", "3.1, fig. 3", "动量和能量是守恒的",
    "and so are those of energy",
    "of the gas over of the spheres, all slabs", "", -1.03, -0.97,
    "3 %: four standard deviations, if a slab has 5 %"),
   ("plume.momentumReference", "3.1, fig. 2", "与典型文献结果[11]进行定量化对比",
    "the rates agree with a reference",
    "momentum over that of the exact exchange in one dimension", "",
    0.97, 1.03, "3 %: one dimension"),
   ("plume.energyReference", "3.1, fig. 3", "与典型文献结果[11]进行定量化对比",
    "the rates agree with a reference",
    "energy over that of the exact exchange in one dimension", "",
    0.97, 1.03, "3 %: one dimension"),
   ("plume.strongExchange", "3.1", "气-固两相之间有较强的动量和能量传递",
    "there is a strong exchange of momentum and energy",
    "share of its initial lag behind the gas that the smaller sphere has lost"
    " at the end", "", 0.2, 1, "a fifth; 1: all", (0.05, 0.2),
    "the channel is a tenth of the length in which a sphere would take the"
    " velocity of this gas; the paper calls strong what its figures show as"
    " rates"))

PLUME = "dsmcParcelFoam/twoPhasePlume"
at(PLUME,
   ("plume.thinsFasterRadially", "3.2, fig. 4a", "沿径向,数密度下降更快",
    "the density of the gas falls faster outwards than along the stream",
    "fall over three exit radii outwards, at x = 3, over that along the axis"
    " from the exit", "", 1.05, 100, "five standard errors; 100: a jet"),
   ("plume.particlesBounded", "3.2, fig. 4b", "固相颗粒的扩散是有界的",
    "the spread of the particles is bounded",
    "angle within which 99 % of the smallest cross the interface", "deg",
    1, 60, "60: the gas fills all angles"),
   ("plume.particlesInCore", "3.2, fig. 4",
    "固体颗粒比较集中地分布在核心区域", "the particles are in the core",
    "radius of half of the particles over that of half of the gas, at x = 6",
    "", 0.1, 0.7, "0.7: half as dense again"),
   ("plume.gasRetarded", "3.2, fig. 5",
    "单相羽流模拟得到的气体流动速度较双相羽流模拟值普遍偏大",
    "the gas without particles is faster everywhere",
    "share of the axis behind x = 1 where it is", "", 0.95, 1,
    "everywhere, but for scatter"),
   ("plume.gasSlower", "3.2, fig. 5", "速度相差约160 m/s",
    "by about 160 m/s at x = 6", "difference of the velocities at x = 6",
    "m/s", 120, 200, "25 %"),
   ("plume.gasHotter", "3.2, fig. 5", "高于单相羽流模拟值约40 K",
    "and the gas with particles is about 40 K hotter there",
    "difference of the temperatures at x = 6", "K", 30, 50, "25 %",
    (150, 350), "160 m/s with only 40 K is out of reach together: the scan of"
    " twoPhasePlume (scan.png) over the product of pressure and radius, the"
    " accommodation, what the particles have at the exit and the mole fractions"
    " finds no motor that misses both by less than a half, not even with"
    " specular particles that give no heat. They would have to take more"
    " energy for a momentum than the velocity of the fastest of them; the"
    " exchange of the paper balances on average only"),
   ("plume.particlesCool", "3.2, fig. 6", "颗粒的温度也逐渐下降",
    "particles cool along the axis",
    "least fall of the five sizes from the exit to x = 9", "K", 5, 1500,
    "fifty times its scatter; 1500: half of the exit's"),
   ("plume.axisCooler", "3.2, fig. 6, (1)",
    "轴线附近的温度比外围的温度稍低",
    "particles near the axis are a little cooler than around it",
    "mean from 0.8 to 1 exit radius less that within 0.4, x = 3 to 5", "K",
    2, 150, "scatter of a run; a little: half of 300 K"),
   ("plume.edgeCoolest", "3.2, fig. 6", "更外围的颗粒温度更低",
    "those further out are cooler still",
    "axis less edge of the cloud at x = 4", "K", 20, 600,
    "scatter; twice the largest difference of the paper"),
   ("plume.particleTemperatures", "3.2, fig. 6", "最大差异在300 K左右",
    "particle temperatures differ by 300 K at most",
    "largest difference in the cloud behind x = 1", "K", 225, 375, "25 %"),
   ("plume.outerFaster", "3.2, fig. 7", "外围颗粒被气相加速较大",
    "outer particles are accelerated more",
    "axial velocity, mean by mass of all sizes, at the edge of the cloud over that on the axis, x = 6",
    "", 1.005, 1.5, "scatter; 1.5: that of the gas"),
   ("plume.smallerFaster", "3.2, fig. 7", "颗粒尺寸越小,越容易被气相加速",
    "the smaller the particle, the more it is accelerated",
    "least ratio of the velocities gained by neighbouring sizes at x = 9", "",
    1.1, 10, "a tenth; 10: as their area per mass"),
   ("plume.thinAtFive", "3.2, fig. 7", "气相数密度比出口处下降1个量级",
    "at x = 5 the gas is one order thinner than at the exit",
    "number density on the axis at x = 5 over that of the exit", "",
    0.0316, 0.316, "half an order either way"),
   ("plume.acceleratedWithinFive", "3.2, (2)",
    "在x-=5以内 ... 气相对固体颗粒有较大影响",
    "most of the acceleration is within x = 5",
    "least share of the gain in speed up to x = 9.5, of five sizes", "",
    0.7, 1, "seven tenths; 1: all"),
   ("plume.cooledWithinFive", "3.2, (2)",
    "不同位置的颗粒温度下降和速度增加较小",
    "and most of the cooling",
    "least share of the fall of temperature up to x = 9.5, of five sizes", "",
    0.7, 1.05, "seven tenths; all, with scatter"))

at(PLUME,
   ("plume.farEdge", "3.2, fig. 8, (3)", "63~115 km范围",
    "after 70 s the smallest particles reach 115 km",
    "far edge of the smallest", "km", 86.25, 143.75,
    "25 %, as all numbers that one motor must have together"),
   ("plume.nearEdge", "3.2, fig. 8, (3)", "63~115 km范围",
    "and begin at 63 km", "near edge of the smallest", "km",
    59.85, 66.15, "5 %", (0.05, 0.5), "a motor that burns for 70 s has"
    " particles of all ages under way, the last of them at the nozzle; 63 km"
    " is where the plots of the paper begin"),
   ("plume.axisymmetric", "3.2, fig. 8", "基本上保持轴对称分布",
    "the distribution keeps its symmetry about the axis",
    "largest deviation of the number in a quadrant from a quarter, in"
    " standard errors", "", 0, 4, "four standard errors"),
   ("plume.spread74", "3.2, fig. 9", "两者基本上呈反比关系",
    "the radius of spread is roughly inverse to the diameter, at 74 km",
    "exponent of the radius in the diameter", "", -1.25, -0.75, "25 %"),
   ("plume.spread115", "3.2, fig. 9, (3)", "颗粒直径越大,扩散半径越小",
    "and at 115 km", "exponent of the radius in the diameter, of sizes that"
    " have come that far", "", -1.25, -0.75, "25 %"),
   ("plume.coolsWithDistance", "3.2, fig. 10, (4)",
    "颗粒温度随远离喷口位置增大而减小",
    "the temperature falls with the distance, 60 to 110 km",
    "least fall of the four larger sizes", "K", 5, 200,
    "scatter; 200: more than they have above the equilibrium"),
   ("plume.largerHotter", "3.2, fig. 10",
    "颗粒尺寸越大 ... 也保持较高的温度",
    "the larger the particle, the hotter, throughout",
    "least difference of neighbouring sizes from 60 to 110 km", "K", 1, 100,
    "scatter; 100: a third of what all of them span"),
   ("plume.smallestInEquilibrium", "3.2, fig. 10",
    "尺寸最小的第1种颗粒温度随位置x基本保持不变而趋近平衡温度",
    "the smallest is nearly at its equilibrium and changes no more",
    "its fall from 60 to 110 km", "K", 0, 3, "nearly nothing"),
   ("plume.othersNotYet", "3.2, fig. 10, (4)", "还未到达平衡温度",
    "the others have not reached theirs",
    "least distance of the four larger from it at 110 km", "K", 1, 200,
    "scatter; 200: as hot as at 60 km"))

# What cannot be checked here: paper, section, quote, what it says, why not
BY_NAME = {s.name: s for s in STATEMENTS}
if len(BY_NAME) != len(STATEMENTS):
    raise ValueError("a name stands for two statements")
for about in STATEMENTS:
    if not (about.low < about.high and about.name.split(".")[0] in PAPERS):
        raise ValueError(f"{about.name}: bounds or paper")
    if about.ours and not (
            about.ours[0] < about.ours[1] and about.reason
            and (about.ours[1] <= about.low or about.ours[0] >= about.high)):
        raise ValueError(f"{about.name}: our bounds reach into the paper's,"
                         " or there is no reason")
