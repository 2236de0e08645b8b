// Cars as seen from above: the one place that draws a car.
#include "car_shape.hpp"

#include <algorithm>
#include <cmath>

namespace snug::drawing {
namespace {

/// Draws in the car's own proportions: u from 0 at the rear to 1 at the front, v from -1 on the right to 1 on the left.
class CarPath {
public:
    CarPath(cairo_t* canvas, const View& view, const Car& car, const Slot& slot, const Pose& pose) : canvas_(canvas) {
        cairo_save(canvas_);
        const cairo_matrix_t matrix = placed(view, slot, pose);
        cairo_transform(canvas_, &matrix);
        cairo_translate(canvas_, -car.rear(), (car.outline().left() - car.outline().right()) / 2);
        cairo_scale(canvas_, car.length(), car.width() / 2);
        cairo_new_path(canvas_);
    }
    ~CarPath() { cairo_restore(canvas_); }  // the path stays; strokes are not scaled
    CarPath(const CarPath&) = delete;
    CarPath& operator=(const CarPath&) = delete;

    void start(double u, double v) { cairo_move_to(canvas_, u, v); }
    void line(double u, double v) { cairo_line_to(canvas_, u, v); }
    void curve(double u1, double v1, double u2, double v2, double u3, double v3) {
        cairo_curve_to(canvas_, u1, v1, u2, v2, u3, v3);
    }
    void close() { cairo_close_path(canvas_); }

private:
    cairo_t* canvas_;
};

void trace_body(CarPath& o) {
    o.start(0.08, -1.0);
    o.line(0.84, -1.0);
    o.curve(0.945, -1.0, 0.982, -0.90, 0.988, -0.58);
    o.curve(1.004, -0.20, 1.004, 0.20, 0.988, 0.58);
    o.curve(0.982, 0.90, 0.945, 1.0, 0.84, 1.0);
    o.line(0.08, 1.0);
    o.curve(0.03, 1.0, 0.008, 0.93, 0.005, 0.66);
    o.curve(-0.002, 0.25, -0.002, -0.25, 0.005, -0.66);
    o.curve(0.008, -0.93, 0.03, -1.0, 0.08, -1.0);
    o.close();
}

/// Windscreen, side and rear windows: a ring around the roof.
void trace_glass(CarPath& o) {
    o.start(0.69, -0.80);
    o.curve(0.735, -0.40, 0.735, 0.40, 0.69, 0.80);
    o.curve(0.64, 0.87, 0.58, 0.88, 0.50, 0.88);
    o.line(0.26, 0.88);
    o.curve(0.18, 0.88, 0.14, 0.84, 0.09, 0.72);
    o.curve(0.07, 0.30, 0.07, -0.30, 0.09, -0.72);
    o.curve(0.14, -0.84, 0.18, -0.88, 0.26, -0.88);
    o.line(0.50, -0.88);
    o.curve(0.58, -0.88, 0.64, -0.87, 0.69, -0.80);
    o.close();
    o.start(0.595, -0.70);
    o.curve(0.625, -0.35, 0.625, 0.35, 0.595, 0.70);
    o.line(0.19, 0.68);
    o.curve(0.165, 0.35, 0.165, -0.35, 0.19, -0.68);
    o.close();
}

}  // namespace

void draw_car(cairo_t* canvas, const View& view, const Car& car, const Slot& slot, const Pose& pose,
              const CarLook& look) {
    {
        CarPath path(canvas, view, car, slot, pose);
        trace_body(path);
    }
    fill_and_stroke(canvas, look.body, look.outline, look.line);
    {
        CarPath path(canvas, view, car, slot, pose);
        trace_glass(path);
    }
    const Saved saved(canvas);
    cairo_set_fill_rule(canvas, CAIRO_FILL_RULE_EVEN_ODD);
    fill(canvas, look.glass);
}

void draw_wheels(cairo_t* canvas, const View& view, const Car& car, const Slot& slot, const Pose& pose,
                 double steering_angle, Color color) {
    const double half_length = 0.065 * car.length();
    const double half_width = 0.05 * car.width();
    const double track = car.width() / 2 - 1.5 * half_width;
    for (const double axle : {0.0, std::min(car.wheelbase(), car.front())}) {
        const double turn = axle == 0.0 ? 0.0 : steering_angle;
        const double c = std::cos(turn);
        const double s = std::sin(turn);
        for (const double side : {-track, track}) {
            std::vector<Point> tyre;
            for (const Point& p : {Point{half_length, half_width}, Point{-half_length, half_width},
                                   Point{-half_length, -half_width}, Point{half_length, -half_width}}) {
                tyre.push_back(on_page(view, slot, pose, {axle + c * p.x - s * p.y, side + s * p.x + c * p.y}));
            }
            trace(canvas, tyre, true);
            fill(canvas, color);
        }
    }
}

void trace_frame(cairo_t* canvas, const View& view, const Car& car, const Slot& slot, const Pose& pose, double grown) {
    std::vector<Point> corners = car.outline().grown(grown).corners();
    for (Point& corner : corners) corner = on_page(view, slot, pose, corner);
    trace(canvas, corners, true);
}

void draw_cross(cairo_t* canvas, const View& view, const Slot& slot, const Pose& pose, Color color) {
    const double arm = 5.0 / view.scale;
    draw_line(canvas, on_page(view, slot, pose, {-arm, 0.0}), on_page(view, slot, pose, {arm, 0.0}), color, 1.3);
    draw_line(canvas, on_page(view, slot, pose, {0.0, -arm}), on_page(view, slot, pose, {0.0, arm}), color, 1.3);
}

}  // namespace snug::drawing
