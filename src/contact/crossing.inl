// The one equation behind every contact: when does a point that turns about a centre reach a line?
//
// A point p of the car, seen from the turning centre, and a line with unit normal n at the distance d from the centre: at the
// heading (c, s) the point is on the line where
//
//     a c + b s = d        a = p . n,   b = p_x n_y - p_y n_x
//
// A fixed point g, seen from the centre, and an edge of the turning car with the outward normal n at the distance e are the
// same equation with a = -g . n, b = g_x n_y - g_y n_x, d = -e. Beyond the line, a c + b s > d, is inside the obstacle (or
// the car). Of the two roots only one leads inward for a clockwise turn, that with a s - b c > 0; that number is `across`.
//
// Included once for the scalar and once for each kind of vector, in the namespace of its numbers: `N` says what they are.

template <class Real>
struct Crossing {
    Real a, b, d;
    Real square;      ///< R^2 - d^2 with R^2 = a^2 + b^2; near tangency best taken as (R - d)(R + d)
    Real per_square;  ///< 1 / R^2
};

/// The heading at which the point turns inward; meaningless where `square` is negative.
template <class Real>
struct Root {
    Real c, s;
    Real across;  ///< how squarely the circle crosses the line [m]
};

template <class N>
SNUG_INLINE Root<typename N::Real> root(const Crossing<typename N::Real>& crossing) {
    const auto across = N::sqrt(crossing.square);
    return {(crossing.a * crossing.d - crossing.b * across) * crossing.per_square,
            (crossing.b * crossing.d + crossing.a * across) * crossing.per_square, across};
}

/// How far beyond the line the point is at a heading. [m]
template <class Real>
SNUG_INLINE Real gap(const Crossing<Real>& crossing, const Real& c, const Real& s) {
    return crossing.a * c + crossing.b * s - crossing.d;
}

/// How the heading of a root changes when the centre moves, by implicit differentiation: `towards` is the centre's speed
/// into the obstacle, n . centre'.
template <class Real>
SNUG_INLINE Real slope_of_root(const Real& towards, const Real& across) {
    return towards / across;
}

/// A corner of the car seen from the turning centre.
template <class Real>
struct SeenCorner {
    Real x, y, radius, per_square;
    int index = 0;  ///< in its outline
};

/// A corner of the car and a wall that faces left (sign 1) or right (sign -1), `along` to the right of the centre.
template <class N, int Sign>
SNUG_INLINE Crossing<typename N::Real> corner_on_wall(const SeenCorner<typename N::Real>& corner,
                                                      const typename N::Real& along) {
    const auto square = (corner.radius - along) * (corner.radius + along);
    if constexpr (Sign > 0) {
        return {corner.x, N::minus(corner.y), along, square, corner.per_square};
    } else {
        return {N::minus(corner.x), corner.y, N::minus(along), square, corner.per_square};
    }
}

/// A corner of the car and level ground, `above` it the centre.
template <class N>
SNUG_INLINE Crossing<typename N::Real> corner_on_ground(const SeenCorner<typename N::Real>& corner,
                                                        const typename N::Real& above) {
    return {N::minus(corner.y), N::minus(corner.x), above, (corner.radius - above) * (corner.radius + above),
            corner.per_square};
}

/// Outward normal of an edge of the car: how far a point, or a direction, leads out over the edge, and to the right along it.
template <class N>
struct Normal {
    typename N::Real x, y;
    SNUG_INLINE typename N::Real out(const typename N::Real& px, const typename N::Real& py) const {
        return px * x + py * y;
    }
    SNUG_INLINE typename N::Real right(const typename N::Real& px, const typename N::Real& py) const {
        return px * y - py * x;
    }
};
/// That of an edge which lies level below the car, or upright on its left: without the multiplications.
template <class N>
struct Downward {
    SNUG_INLINE typename N::Real out(const typename N::Real&, const typename N::Real& py) const { return N::minus(py); }
    SNUG_INLINE typename N::Real right(const typename N::Real& px, const typename N::Real&) const {
        return N::minus(px);
    }
};
template <class N>
struct Leftward {
    SNUG_INLINE typename N::Real out(const typename N::Real& px, const typename N::Real&) const { return N::minus(px); }
    SNUG_INLINE typename N::Real right(const typename N::Real&, const typename N::Real& py) const { return py; }
};

/// A fixed point (gx, gy) and an edge of the car with this outward normal, at the distance `off` from the centre.
template <class N, class AnyNormal, class Real = typename N::Real>
SNUG_INLINE Crossing<Real> point_on_edge(const Real& gx, const Real& gy, const AnyNormal& normal, const Real& off) {
    const Real reach = gx * gx + gy * gy;
    return {N::minus(normal.out(gx, gy)), normal.right(gx, gy), N::minus(off), reach - off * off, N::set(1.0) / reach};
}
