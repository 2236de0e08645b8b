// Where the car thinks it is: what it measured weighed against what it thinks it drove.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "snug/geometry.hpp"

namespace snug {

/// An extended Kalman filter over the pose and what the curvature is off from what was steered.
class PoseFilter {
public:
    PoseFilter(const Pose& seen, const Pose& deviation) : pose_(seen) {
        p_[0][0] = deviation.x * deviation.x;
        p_[1][1] = deviation.y * deviation.y;
        p_[2][2] = deviation.heading * deviation.heading;
    }

    [[nodiscard]] const Pose& pose() const { return pose_; }
    [[nodiscard]] double curvature() const { return off_; }  ///< [1/m]

    /// A new move: its curvature is off by something new.
    void forget_curvature(double deviation) {
        off_ = 0.0;
        for (std::size_t i = 0; i < 4; ++i) p_[3][i] = p_[i][3] = 0.0;
        p_[3][3] = deviation * deviation;
    }

    /// Rolled that far (negative: backward) with that curvature steered.
    void roll(double ds, double steered) {
        const double curvature = steered + off_;
        const double middle = pose_.heading + curvature * ds / 2.0;
        const double c = std::cos(middle), s = std::sin(middle);
        pose_.x += ds * c;
        pose_.y += ds * s;
        pose_.heading += curvature * ds;
        // F = identity + these entries; P becomes F P F^T.
        const std::array<std::array<double, 4>, 4> f = {{{1.0, 0.0, -ds * s, -ds * ds * s / 2.0},
                                                         {0.0, 1.0, ds * c, ds * ds * c / 2.0},
                                                         {0.0, 0.0, 1.0, ds},
                                                         {0.0, 0.0, 0.0, 1.0}}};
        p_ = times(times(f, p_), transposed(f));
    }

    /// Came to rest somewhere else along its way, on which it turned, too.
    void slip(double deviation, double steered) {
        const std::array<double, 4> along = {std::cos(pose_.heading), std::sin(pose_.heading), steered + off_, 0.0};
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) p_[i][j] += deviation * deviation * along[i] * along[j];
    }

    /// What it stands beside is now seen elsewhere, by about so much.
    void wander(double deviation) {
        p_[0][0] += deviation * deviation;
        p_[1][1] += deviation * deviation;
    }

    /// Measured, with that standard deviation of each part.
    void see(const Pose& seen, const Pose& deviation) {
        weigh(0, seen.x - pose_.x, deviation.x);
        weigh(1, seen.y - pose_.y, deviation.y);
        weigh(2, seen.heading - pose_.heading, deviation.heading);
    }

private:
    using Matrix = std::array<std::array<double, 4>, 4>;

    void weigh(std::size_t part, double difference, double deviation) {
        // Not quite certain even where nothing errs: else rounding would decide what is believed.
        const double least = 1e-4;
        const double total = std::max(p_[part][part], 0.0) + std::max(deviation * deviation, least * least);
        std::array<double, 4> gain;
        for (std::size_t i = 0; i < 4; ++i) gain[i] = p_[i][part] / total;
        pose_.x += gain[0] * difference;
        pose_.y += gain[1] * difference;
        pose_.heading += gain[2] * difference;
        off_ += gain[3] * difference;
        const std::array<double, 4> row = p_[part];
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) p_[i][j] -= gain[i] * row[j];
    }
    static Matrix times(const Matrix& a, const Matrix& b) {
        Matrix product = {};
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j)
                for (std::size_t k = 0; k < 4; ++k) product[i][j] += a[i][k] * b[k][j];
        return product;
    }
    static Matrix transposed(const Matrix& a) {
        Matrix result;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) result[i][j] = a[j][i];
        return result;
    }

    Pose pose_;
    double off_ = 0.0;
    Matrix p_ = {};
};

}  // namespace snug
