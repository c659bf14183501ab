/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "convexBody.H"
#include "outOfRange.H"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace
{

using impact::vector3;
typedef impact::convexBody::surface surface;

void checkSize(const char* what, const vector3& size)
{
    for (int i = 0; i < 3; ++i)
    {
        if (!impact::within(size[i], "(0, 1e100)"))
        {
            impact::throwInvalid
            (
                what, " (", size.x, ' ', size.y, ' ', size.z,
                "): valid range of components (0, 1e100) m"
            );
        }
    }
}


//- Faces of the convex hull of points, given their outward normals
surface hull
(
    const std::vector<vector3>& points,
    const std::vector<vector3>& normals
)
{
    surface s;
    s.points = points;
    for (const vector3& n : normals)
    {
        double top = -1e300;
        for (const vector3& p : points)
        {
            top = std::max(top, dot(n, p));
        }
        std::vector<int> face;
        vector3 centre = {0, 0, 0};
        for (int i = 0; i < int(points.size()); ++i)
        {
            if (dot(n, points[i]) > top - 1e-9*std::fabs(top))
            {
                face.push_back(i);
                centre = centre + points[i];
            }
        }
        centre = (1./face.size())*centre;
        const vector3 e1 = points[face[0]] - centre;
        const vector3 e2 = cross(n, e1);
        auto angle = [&](int i)
        {
            const vector3 d = points[i] - centre;
            return std::atan2(dot(d, e2)*mag(e1), dot(d, e1)*mag(e2));
        };
        std::sort
        (
            face.begin(),
            face.end(),
            [&](int i, int j) { return angle(i) < angle(j); }
        );
        s.faces.push_back(face);
    }
    return s;
}


//- Twice the area vector of a plane polygon
vector3 areaVector(const surface& s, const std::vector<int>& face)
{
    vector3 a = {0, 0, 0};
    for (std::size_t k = 2; k < face.size(); ++k)
    {
        a = a + cross
        (
            s.points[face[k - 1]] - s.points[face[0]],
            s.points[face[k]] - s.points[face[0]]
        );
    }
    return a;
}


void checkClosedAndConvex(const surface& s, double radius)
{
    std::map<std::pair<int, int>, int> count;
    for (const auto& face : s.faces)
    {
        for (std::size_t k = 0; k < face.size(); ++k)
        {
            ++count[{face[k], face[(k + 1) % face.size()]}];
        }
    }
    for (const auto& c : count)
    {
        if (c.second != 1 || !count.count({c.first.second, c.first.first}))
        {
            throw std::invalid_argument
            (
                "the surface is not closed: an edge does not lie between"
                " exactly two faces of the same orientation"
            );
        }
    }
    for (const auto& face : s.faces)
    {
        const vector3 a = areaVector(s, face);
        if (!(mag(a) > 0))
        {
            throw std::invalid_argument
            (
                "the surface has a face of zero area"
            );
        }
        const vector3 n = (1/mag(a))*a;
        for (const vector3& p : s.points)
        {
            if (dot(n, p - s.points[face[0]]) > 1e-6*radius)
            {
                throw std::invalid_argument
                (
                    "the body is not convex: a vertex lies outside the plane"
                    " of a face"
                );
            }
        }
    }
}


//- Volume, centre and second moments about it of a closed surface, by
//  tetrahedra with the origin
struct surfaceMoments
{
    double volume6;
    vector3 centre;
    Eigen::Matrix3d second;

    explicit surfaceMoments(const surface& s)
    :
        volume6(0),
        centre{0, 0, 0},
        second(Eigen::Matrix3d::Zero())
    {
        vector3 first = {0, 0, 0};
        for (const auto& face : s.faces)
        {
            for (std::size_t k = 2; k < face.size(); ++k)
            {
                const vector3& a = s.points[face[0]];
                const vector3& b = s.points[face[k - 1]];
                const vector3& c = s.points[face[k]];
                const double det = dot(a, cross(b, c));
                const vector3 sum = a + b + c;
                volume6 += det;
                first = first + det/4*sum;
                for (int i = 0; i < 3; ++i)
                {
                    for (int j = 0; j < 3; ++j)
                    {
                        second(i, j) += det/20
                           *(a[i]*a[j] + b[i]*b[j] + c[i]*c[j] + sum[i]*sum[j]);
                    }
                }
            }
        }
        if (!(volume6 > 0))
        {
            return;
        }
        centre = (1/volume6)*first;
        second /= volume6;
        for (int i = 0; i < 3; ++i)
        {
            for (int j = 0; j < 3; ++j)
            {
                second(i, j) -= centre[i]*centre[j];
            }
        }
    }

    //- Turn the second moments into their principal frame. Axes that are
    //  principal already are kept in their order.
    //  \return axes
    Eigen::Matrix3d diagonalise()
    {
        Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
        const double off = std::max
        ({
            std::fabs(second(0, 1)), std::fabs(second(1, 2)),
            std::fabs(second(2, 0))
        });
        if (off > 1e-13*second.trace())
        {
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(second);
            axes = solver.eigenvectors();
            if (axes.determinant() < 0)
            {
                axes.col(2) *= -1;
            }
            second = axes.transpose()*second*axes;
        }
        return axes;
    }
};

} // End anonymous namespace


void impact::convexBody::setSymmetryAxis()
{
    const vector3& J = inertia_;
    const double tolerance = 1e-12*std::max({J.x, J.y, J.z});
    const bool xy = std::fabs(J.x - J.y) <= tolerance;
    const bool yz = std::fabs(J.y - J.z) <= tolerance;
    const bool zx = std::fabs(J.z - J.x) <= tolerance;
    symmetryAxis_ = xy && yz ? 3 : yz ? 0 : zx ? 1 : xy ? 2 : -1;
}


impact::convexBody impact::convexBody::sphere(double diameter)
{
    checkSize("sphere diameter", {diameter, diameter, diameter});
    return ellipsoid({diameter, diameter, diameter});
}


impact::convexBody impact::convexBody::ellipsoid(const vector3& size)
{
    checkSize("ellipsoid size", size);
    convexBody b;
    b.shape_ = shapeType::ellipsoid;
    b.semiAxes_ = 0.5*size;
    const vector3 a2 = multiply(b.semiAxes_, b.semiAxes_);
    b.inertia_ =
        {(a2.y + a2.z)/5, (a2.z + a2.x)/5, (a2.x + a2.y)/5};
    b.volume_ = 4*M_PI/3*b.semiAxes_.x*b.semiAxes_.y*b.semiAxes_.z;
    b.radius_ = std::max({b.semiAxes_.x, b.semiAxes_.y, b.semiAxes_.z});
    b.setSymmetryAxis();
    return b;
}


impact::convexBody impact::convexBody::box(const vector3& size)
{
    checkSize("box size", size);
    const vector3 h = 0.5*size;
    surface s;
    for (int i = 0; i < 8; ++i)
    {
        s.points.push_back
        (
            {(i & 1 ? h.x : -h.x), (i & 2 ? h.y : -h.y), (i & 4 ? h.z : -h.z)}
        );
    }
    s.faces =
    {
        {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
        {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}
    };
    convexBody b;
    b.setPolyhedron(s);
    return b;
}


impact::convexBody impact::convexBody::truncatedBox
(
    const vector3& size,
    double cut
)
{
    checkSize("truncatedBox size", size);
    checkRange("cut", cut, "(0, 0.5)");
    const vector3 h = 0.5*size;
    std::vector<vector3> points, normals;
    for (int i = 0; i < 8; ++i)
    {
        const vector3 corner =
            {(i & 1 ? h.x : -h.x), (i & 2 ? h.y : -h.y), (i & 4 ? h.z : -h.z)};
        for (int axis = 0; axis < 3; ++axis)
        {
            vector3 p = corner;
            p[axis] *= 1 - 2*cut;
            points.push_back(p);
        }
        normals.push_back
        (
            {(i & 1 ? 1 : -1)/h.x, (i & 2 ? 1 : -1)/h.y, (i & 4 ? 1 : -1)/h.z}
        );
    }
    for (int axis = 0; axis < 3; ++axis)
    {
        vector3 n = {0, 0, 0};
        n[axis] = 1;
        normals.push_back(n);
        normals.push_back(-n);
    }
    convexBody b;
    b.setPolyhedron(hull(points, normals));
    return b;
}


impact::convexBody impact::convexBody::polyhedron(const surface& s)
{
    convexBody b;
    b.setPolyhedron(s);
    return b;
}


void impact::convexBody::setPolyhedron(surface s)
{
    if (s.points.size() < 4 || s.faces.size() < 4)
    {
        throw std::invalid_argument
        (
            "a polyhedron needs at least 4 vertices and 4 faces"
        );
    }
    vector3 origin = {0, 0, 0};
    double radius = 0;
    for (const vector3& p : s.points)
    {
        origin = origin + (1./s.points.size())*p;
    }
    for (vector3& p : s.points)
    {
        p = p - origin;
        radius = std::max(radius, mag(p));
    }
    if (!(radius > 0) || !(radius < 1e100))
    {
        throw std::invalid_argument
        (
            "the vertices of a polyhedron must be finite and not coincide"
        );
    }

    surfaceMoments moments(s);
    if (moments.volume6 < -1e-9*radius*radius*radius)
    {
        throw std::invalid_argument
        (
            "the surface is inside out: its faces must be ordered"
            " counter-clockwise seen from outside"
        );
    }
    checkClosedAndConvex(s, radius);
    if (!(moments.volume6 > 0))
    {
        throw std::invalid_argument("the polyhedron has no volume");
    }

    const Eigen::Matrix3d axes = moments.diagonalise();
    const Eigen::Matrix3d& second = moments.second;
    shape_ = shapeType::polyhedron;
    volume_ = moments.volume6/6;
    inertia_ =
    {
        second(1, 1) + second(2, 2),
        second(2, 2) + second(0, 0),
        second(0, 0) + second(1, 1)
    };
    for (vector3& p : s.points)
    {
        const vector3 d = p - moments.centre;
        for (int i = 0; i < 3; ++i)
        {
            p[i] = d.x*axes(0, i) + d.y*axes(1, i) + d.z*axes(2, i);
            semiAxes_[i] = std::max(semiAxes_[i], std::fabs(p[i]));
        }
        radius_ = std::max(radius_, mag(p));
    }
    setSpokes(setEdges(s));
    setSymmetryAxis();
    isBox_ = vertices_.size() == 8;
    for (const vector3& v : vertices_)
    {
        for (int i = 0; i < 3; ++i)
        {
            isBox_ = isBox_
             && std::fabs(std::fabs(v[i]) - semiAxes_[i]) < 1e-14*radius_;
        }
    }
}


std::vector<impact::convexBody::edge> impact::convexBody::setEdges
(
    const surface& s
)
{
    // Edges between coplanar faces (a triangulated surface) are none of the
    // body's; nor are vertices that lie inside a face
    std::map<edge, std::vector<int>> facesOf;
    for (const auto& face : s.faces)
    {
        const vector3 a = areaVector(s, face);
        for (std::size_t k = 0; k < face.size(); ++k)
        {
            const int i = face[k];
            const int j = face[(k + 1) % face.size()];
            facesOf[{{std::min(i, j), std::max(i, j)}}]
                .push_back(int(faceNormals_.size()));
        }
        faceNormals_.push_back((1/mag(a))*a);
    }
    std::vector<int> newLabel(s.points.size(), -1);
    std::vector<edge> between;
    for (const auto& f : facesOf)
    {
        const edge faces = {{f.second[0], f.second[1]}};
        if (mag(cross(faceNormals_[faces[0]], faceNormals_[faces[1]])) > 1e-7)
        {
            edge e = f.first;
            for (int& v : e)
            {
                if (newLabel[v] < 0)
                {
                    newLabel[v] = int(vertices_.size());
                    vertices_.push_back(s.points[v]);
                }
                v = newLabel[v];
            }
            edges_.push_back(e);
            between.push_back(faces);
        }
    }
    return between;
}


void impact::convexBody::setSpokes(const std::vector<edge>& between)
{
    const auto padded = [](std::size_t n) { return (n + 7)/8*8; };
    for (int axis = 0; axis < 3; ++axis)
    {
        for (std::size_t i = 0; i < padded(vertices_.size()); ++i)
        {
            paddedVertices_.push_back
                (vertices_[std::min(i, vertices_.size() - 1)][axis]);
        }
    }
    for (int i = 0; i < int(vertices_.size()); ++i)
    {
        firstSpoke_.push_back(int(spokes_.size()));
        for (std::size_t k = 0; k < edges_.size(); ++k)
        {
            const edge& e = edges_[k];
            if (e[0] == i || e[1] == i)
            {
                const edge& faces = between[k];
                spokes_.push_back
                    ({e[0] == i ? e[1] : e[0], {faces[0], faces[1]}});
            }
        }
    }
    firstSpoke_.push_back(int(spokes_.size()));
    for (const edge& e : edges_)
    {
        longestEdge_ = std::max
            (longestEdge_, mag(vertices_[e[0]] - vertices_[e[1]]));
    }
}


double impact::convexBody::minCurvature() const
{
    if (shape_ == shapeType::polyhedron)
    {
        return 0;
    }
    const double minAxis = std::min({semiAxes_.x, semiAxes_.y, semiAxes_.z});

    // minAxis <= radius, but the quotient may round up: no ball is larger than
    // the body
    return std::min(minAxis, minAxis*minAxis/radius_);
}


impact::vector3 impact::convexBody::support(const vector3& n) const
{
    if (shape_ == shapeType::ellipsoid)
    {
        const vector3 s = multiply(semiAxes_, n);
        return (1/mag(s))*multiply(semiAxes_, s);
    }
    double top = -1e300;
    for (const vector3& v : vertices_)
    {
        top = std::max(top, dot(n, v));
    }
    vector3 sum = {0, 0, 0};
    int count = 0;
    for (const vector3& v : vertices_)
    {
        if (dot(n, v) >= top - 1e-9*radius_)
        {
            sum = sum + v;
            ++count;
        }
    }
    return (1./count)*sum;
}
