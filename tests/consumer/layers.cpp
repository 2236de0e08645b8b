// A program that links everything installed.
#include <snug/atlas_database.hpp>
#include <snug/draw.hpp>
#include <snug/drive.hpp>
#include <snug/io.hpp>
#include <snug/snug.hpp>
#include <snug/sweep.hpp>

#include <iostream>
#include <nlohmann/json.hpp>

int main() {
    const snug::Car car = snug::car_from_json(
        R"({"width": 1.8, "front": 3.6, "rear": 0.8, "wheelbase": 2.6, "curb_to_curb": 10.9})", "a data sheet");
    const snug::Slot slot({.length = 5.0, .width = 2.1});
    const std::string picture = snug::draw_maneuver(car, slot, snug::entry(car, slot), snug::PictureFormat::svg);
    const std::string nothing = snug::solve(car, 2.1, 5.0, {})->direction_changes ? "" : "out";
    snug::Street street;
    street.length = 6.0;
    street.width = 2.4;
    snug::DriveOptions drive;
    drive.margin = 0.05;
    drive.runs = 1;
    const snug::DriveAnswer runs = drive_runs(car, street_place(street), standard_start(street, car), drive);
    std::cout << "with" << nothing << " an answer for the atlas, " << snug::min_slots(car, {2.0, 2.2}, {1, 2}).size()
              << " slots, a picture that begins with " << picture.substr(0, 5) << ", a car that is "
              << snug::as_json(car)["width"] << " m wide, " << runs.parked() << " of 1 run parked\n";
}
