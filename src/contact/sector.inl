// First contact within a sector of headings, while the same corners of the car lead: the lowest, the leftmost, the rightmost.
//
// A convex car can then meet the world in five ways only:
//
//     rightmost corner - front side        lowest corner - curb          leftmost corner - rear side
//     edge between rightmost and           edge between leftmost and
//     lowest corner - front corner         lowest corner - rear corner
//
// (and, coming from the road, the lowest corner can land on a neighbour). Each is a crossing (crossing.inl).
//
// Included like crossing.inl, once for each kind of number; the same operations in the same order, so every kind has the
// same bits.

/// What the car turns among, seen from the turning centre.
template <class Real>
struct Surroundings {
    Real x, y;         ///< of the turning centre [m]
    Real length;       ///< of the slot [m]
    Real above_curb;   ///< of the centre [m]
    Real above_front;  ///< above the top of the front neighbour [m]
    Real above_rear;   ///< above the top of the rear neighbour [m]
    Real touch;        ///< closer than this is touching [m]
};

/// An edge of the car seen from the turning centre, as far as a fixed point can enter over it: there it moves along the
/// edge's direction away from the foot of the centre.
template <class N>
struct SeenEdge {
    typename N::Real distance;              ///< from the centre, along the outward normal [m]
    typename N::Real from, to;              ///< its ends, along the edge from the foot of the centre [m]
    typename N::Mask slips_back, slips_on;  ///< what meets the one or the other end misses the car
    int index = 0;                          ///< in the outline: an edge follows its corner
};

/// How a part of the car and an obstacle stand at the start: closing in, or corner to corner and bound to miss each other.
template <class N>
struct AtStart {
    typename N::Mask touching;   ///< and closing in,
    typename N::Mask slips_off;  ///< but bound to miss it

    [[nodiscard]] SNUG_INLINE typename N::Mask touches() const { return N::both(touching, N::opposite(slips_off)); }
};

/// First contact while turning clockwise, from the heading (c, s). What touches already and would move in is met at once;
/// what touches and moves away, or along, is not met. `Found` keeps what is to be known of the contacts.
/// Where a circle only just reaches a line is looked at carefully or, in lanes, only noticed: that is rare and costs time.
template <class N, class Found, bool Careful = true>
struct First {
    using Real = typename N::Real;
    using Mask = typename N::Mask;

    Real start_c, start_s, start_order;
    Real end_order;  ///< of the sector
    Real c, s;       ///< of the first contact
    Real order;      ///< s - c falls with the heading: the first contact has the largest; -2 if there is none
    Found found;
    Real closest;  ///< not Careful: to a root's square of 0 [m^2]

    SNUG_INLINE First(Real from_c, Real from_s, Real end)
        : start_c(from_c),
          start_s(from_s),
          start_order(from_s - from_c),
          end_order(end),
          c(N::set(1.0)),
          s(N::set(0.0)),
          order(N::set(-2.0)),
          closest(N::set(1.0)) {}

    SNUG_INLINE First& operator=(const First<N, Found, !Careful>& looked_at_otherwise) {
        c = looked_at_otherwise.c;
        s = looked_at_otherwise.s;
        order = looked_at_otherwise.order;
        found = looked_at_otherwise.found;
        return *this;
    }

    /// `at_start` is asked only of what has its root near the start.
    template <class Ask>
    SNUG_INLINE void consider(const Root<Real>& at, Mask exists, const Ask& at_start, Meets meets, int part) {
        const Real at_order = at.s - at.c;
        const Real later = start_order - at_order;
        if constexpr (N::alone) {  // the same as below; mostly only the last question is asked
            if (!exists) return;
            bool touches = false;
            if (later < near_start) {
                if (!(later > -near_start)) return;
                const AtStart<N> found_there = at_start();
                touches = found_there.touching && !found_there.slips_off;
                if (!touches && (found_there.touching || !(later >= 0.0))) return;
            }
            if (!touches && !(N::least(at.s, at.c) >= 0.0 && at_order >= end_order)) return;
            found.lies_ahead(true, meets);
            const bool there = touches || later == 0.0;  // what is met at the start is met right there
            const Real met_order = there ? start_order : at_order;
            if (!(met_order > order)) return;
            c = there ? start_c : at.c;
            s = there ? start_s : at.s;
            order = met_order;
            found.is_first(true, at.across, meets, part);
        } else {
            const Mask ahead =
                N::least(N::least(at.s, at.c), later) >= N::set(0.0);  // a sector is a whole quarter turn
            Mask met = N::both(exists, ahead);
            Real met_order = at_order;
            const Mask near = N::both(exists, N::abs(later) < N::set(near_start));
            if (N::some(near)) {
                const AtStart<N> found_there = at_start();
                const Mask touching = N::both(near, found_there.touching);
                const Mask touches = N::both(touching, N::opposite(found_there.slips_off));
                met = N::either(touches, N::both(met, N::opposite(touching)));
                met_order = N::select(touches, start_order, at_order);
            }
            found.lies_ahead(met, meets);
            const Mask earlier = N::both(met, met_order > order);
            c = N::select(earlier, at.c, c);
            s = N::select(earlier, at.s, s);
            order = N::select(earlier, met_order, order);
            found.is_first(earlier, at.across, meets, part);
        }
    }

    /// Rounding can have a circle end short of a line that it only just reaches. It is taken to reach it there; whoever asks
    /// must see that the car touches the line from the start, for then its first way is what decides: in or away.
    SNUG_INLINE Mask just_reaches(Crossing<Real>& crossing, Real radius, Real touch) {
        if constexpr (Careful) {
            const Real rounding = radius * touch;
            const Mask just = N::both(crossing.square < N::set(0.0), crossing.square >= N::minus(rounding));
            if (N::rarely(just)) crossing.square = N::select(just, N::set(0.0), crossing.square);
            return just;
        } else {
            closest = N::least(closest, N::abs(crossing.square));
            return N::never();
        }
    }

    template <class Ask>
    static SNUG_INLINE Mask unless_just(Mask just, Mask exists, const Ask& at_start) {
        if constexpr (Careful)
            if (N::rarely(just)) return N::both(exists, N::either(N::opposite(just), at_start().touches()));
        return exists;
    }

    /// A corner of the car meets the upright side of a neighbour, to the right (sign 1) or to the left (sign -1).
    template <int Sign>
    SNUG_INLINE void corner_meets_side(const SeenCorner<Real>& corner, Real along, Real above_top, Real touch,
                                       Meets meets) {
        // What moves inward lies above the centre on its right and below it on its left, as far as the circle crosses squarely.
        if constexpr (N::alone && Sign > 0) {
            if (above_top > 2.0 * touch) return;
        }
        Crossing<Real> crossing = corner_on_wall<N, Sign>(corner, along);
        const Mask just = just_reaches(crossing, corner.radius, touch);
        if constexpr (N::alone) {  // told from the root's square; nor where there is no root
            const Real top = Sign > 0 ? 2.0 * touch - above_top : above_top - 2.0 * touch;
            if (Sign > 0 ? !(crossing.square <= top * top) : top > 0.0 && !(crossing.square >= top * top)) return;
            if (!(crossing.square >= 0.0)) return;
        }
        const Root<Real> at = root<N>(crossing);
        const Real height = above_top + corner.x * at.s + corner.y * at.c;
        Mask exists = height <= touch;  // false where there is no root
        const auto at_start = [&]() SNUG_LAMBDA {
            const Real start_x = corner.x * start_c - corner.y * start_s;
            const Real start_y = corner.x * start_s + corner.y * start_c;
            const Mask closes = Sign > 0 ? start_y > N::set(0.0) : start_y < N::set(0.0);
            const Mask touching = N::both(N::abs(along - start_x) <= touch, closes);
            return AtStart<N>{touching, N::both(above_top + start_y >= N::set(0.0) - touch, start_x <= N::set(0.0))};
        };
        // Rounding may have lifted a corner that touches above the wall's end, or ended its circle short of the wall.
        Mask sure = height <= N::set(0.0);
        if constexpr (Careful) sure = N::both(sure, N::opposite(just));
        if constexpr (N::alone) {
            if (!sure && !(exists && at_start().touches())) return;
        } else {
            const Mask unsure = N::both(exists, N::opposite(sure));
            exists = N::rarely(unsure) ? N::either(sure, N::both(unsure, at_start().touches())) : sure;
        }
        consider(at, exists, at_start, meets, corner.index);
    }

    SNUG_INLINE void corner_meets_curb(const SeenCorner<Real>& corner, Real above, Real touch) {
        Crossing<Real> crossing = corner_on_ground<N>(corner, above);
        const Mask just = just_reaches(crossing, corner.radius, touch);
        const Mask exists = crossing.square >= N::set(0.0);
        if constexpr (N::alone) {
            if (!exists) return;
        }
        const auto at_start = [&]() SNUG_LAMBDA {
            const Real start_x = corner.x * start_c - corner.y * start_s;
            const Real start_y = corner.x * start_s + corner.y * start_c;
            const Mask touching = N::both(N::abs(start_y + above) <= touch, start_x > N::set(0.0));
            return AtStart<N>{touching, N::never()};
        };
        consider(root<N>(crossing), unless_just(just, exists, at_start), at_start, Meets::curb, corner.index);
    }

    /// The lowest corner comes down upon a neighbour, whose end at the slot lies `end` to the right of the centre.
    template <int Sign>
    SNUG_INLINE void corner_meets_top(const SeenCorner<Real>& corner, Real above, Real end, Mask high, Real touch,
                                      Meets meets) {
        Crossing<Real> crossing = corner_on_ground<N>(corner, above);
        const Mask just = just_reaches(crossing, corner.radius, touch);
        Mask exists = N::both(high, crossing.square >= N::set(0.0));
        if (N::none(exists)) return;
        const Root<Real> at = root<N>(crossing);
        const Real where = corner.x * at.c - corner.y * at.s;
        const Real beyond_end = Sign > 0 ? where - end : end - where;
        exists = N::both(exists, beyond_end >= N::set(0.0) - touch);
        if (N::none(exists)) return;
        const auto at_start = [&]() SNUG_LAMBDA {
            const Real start_x = corner.x * start_c - corner.y * start_s;
            const Real start_y = corner.x * start_s + corner.y * start_c;
            const Mask touching = N::both(N::abs(start_y + above) <= touch, start_x > N::set(0.0));
            const Mask moves_onto = Sign > 0 ? start_y > N::set(0.0) : start_y < N::set(0.0);
            return AtStart<N>{N::both(touching, N::either(beyond_end > touch, moves_onto)), N::never()};
        };
        const Mask unsure = N::either(just, beyond_end <= touch);
        if (!N::none(unsure)) exists = N::both(exists, N::either(N::opposite(unsure), at_start().touches()));
        consider(at, exists, at_start, meets, corner.index);
    }

    /// A neighbour's corner (gx, gy), seen from the centre, meets an edge of the car with this outward normal.
    template <class AnyNormal>
    SNUG_INLINE void edge_meets_corner(const SeenEdge<N>& edge, const AnyNormal& normal, Real gx, Real gy, Real touch,
                                       Meets meets) {
        Crossing<Real> crossing = point_on_edge<N>(gx, gy, normal, edge.distance);
        const Mask just = just_reaches(crossing, N::abs(edge.distance), touch);
        const Root<Real> at = root<N>(crossing);
        // Both are false where there is no root.
        const Mask short_of_end = at.across <= edge.to + touch;
        const Mask past_start = at.across >= edge.from - touch;
        if constexpr (N::alone) {
            if (!short_of_end) return;
            if (!past_start) return;
        }
        const auto at_start = [&]() SNUG_LAMBDA {
            const Real start_x = gx * start_c + gy * start_s;
            const Real start_y = gy * start_c - gx * start_s;
            const Real start_off = normal.out(start_x, start_y);
            const Real start_along = N::minus(normal.right(start_x, start_y));
            // A point that the edge only just reaches is on it where it is farthest from the centre: either way it goes in.
            Mask closes = start_along > N::set(0.0);
            if constexpr (Careful) closes = N::either(closes, just);
            const Mask touching = N::both(N::abs(start_off - edge.distance) <= touch, closes);
            const Mask beyond = N::both(start_along >= edge.to - touch, edge.slips_on);
            const Mask before = N::both(start_along <= edge.from + touch, edge.slips_back);
            return AtStart<N>{touching, N::either(beyond, before)};
        };
        const Mask exists = N::both(short_of_end, past_start);
        consider(at, unless_just(just, exists, at_start), at_start, meets, edge.index);
    }

    /// Everything but the edges. `at_curb` is the lowest corner of what stops at the curb.
    SNUG_INLINE void corners_meet(const SeenCorner<Real>& lowest, const SeenCorner<Real>& leftmost,
                                  const SeenCorner<Real>& rightmost, const SeenCorner<Real>& at_curb,
                                  const Surroundings<Real>& around) {
        const Real front = N::set(0.0) - around.x;
        const Real rear = front - around.length;
        corner_meets_side<1>(rightmost, front, around.above_front, around.touch, Meets::front_side);
        corner_meets_side<-1>(leftmost, rear, around.above_rear, around.touch, Meets::rear_side);
        corner_meets_curb(at_curb, around.above_curb, around.touch);
        const Real low = lowest.x * start_s + lowest.y * start_c;
        const Mask above_front = around.above_front + low > N::set(0.0) - around.touch;
        if (N::rarely(above_front))
            corner_meets_top<1>(lowest, around.above_front, front, above_front, around.touch, Meets::front_top);
        const Mask above_rear = around.above_rear + low > N::set(0.0) - around.touch;
        if (N::rarely(above_rear))
            corner_meets_top<-1>(lowest, around.above_rear, rear, above_rear, around.touch, Meets::rear_top);
    }

    /// Everything, of a rectangle: it has one edge on either side of the lowest corner.
    SNUG_INLINE void rectangle_meets(const SeenCorner<Real>& lowest, const SeenCorner<Real>& leftmost,
                                     const SeenCorner<Real>& rightmost, const SeenCorner<Real>& at_curb,
                                     const Surroundings<Real>& around) {
        const Real zero = N::set(0.0);
        corners_meet(lowest, leftmost, rightmost, at_curb, around);
        const SeenEdge<N> below = {N::minus(lowest.y), lowest.x,         rightmost.x,
                                   lowest.y >= zero,   lowest.y <= zero, lowest.index};
        edge_meets_corner(below, Downward<N>(), zero - around.x, zero - around.above_front, around.touch,
                          Meets::front_corner);
        const SeenEdge<N> left = {N::minus(lowest.x), N::minus(leftmost.y), N::minus(lowest.y),
                                  lowest.x >= zero,   lowest.x <= zero,     leftmost.index};
        edge_meets_corner(left, Leftward<N>(), zero - around.x - around.length, zero - around.above_rear, around.touch,
                          Meets::rear_corner);
    }

    [[nodiscard]] SNUG_INLINE Mask at_the_start() const { return order == start_order; }

    /// What is met at the start is met right there.
    SNUG_INLINE void settle() {
        c = N::select(at_the_start(), start_c, c);
        s = N::select(at_the_start(), start_s, s);
    }
};
