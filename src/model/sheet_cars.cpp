// Which numbers public data sheets give for cars that people know, and which sheets those are.
#include <string>
#include <vector>

#include "snug/car.hpp"

namespace snug {
namespace {

constexpr double foot = 0.3048;  // [m]

/// As sheets give it: lengths in millimetres, which keeps their sums exact, and the circle's diameter in metres.
struct Sheet {
    const char* name;
    int width;
    int wheelbase;
    int front_overhang;
    int rear_overhang;
    double curb_to_curb;
    const char* title;
    const char* circle;
    const char* source;
};

SheetCar read_off(const Sheet& sheet) {
    const double width = sheet.width / 1000.0;
    const double wheelbase = sheet.wheelbase / 1000.0;
    const double front = (sheet.wheelbase + sheet.front_overhang) / 1000.0;
    const double max_steer = steer_for_curb_to_curb(wheelbase, width, sheet.curb_to_curb);
    return {Car({width, front, sheet.rear_overhang / 1000.0, wheelbase, max_steer}, sheet.name), sheet.title,
            sheet.circle, sheet.source};
}

}  // namespace

std::vector<SheetCar> sheet_cars() {
    // Only what was read with overhangs, wheelbase, length and circle. Where wheelbase and overhangs do not make up the
    // length, the car is the longer of the two, so that what fits here fits there.
    std::vector<SheetCar> cars;
    for (const Sheet& sheet : {
             Sheet{"citroen-jumper", 2050, 4035, 948, 1015, 14.14, "Citroen, technical data, Jumper, April 2010",
                   "14.14 m, curb to curb",
                   "The sheet of Citroen in France, written down in github.com/billiet-cadart/van,\n"
                   "docs/dimensions-l3h2.md\n"
                   "The long van, L3H2 33 and 35. The body is the Fiat Ducato's and the Peugeot Boxer's too, and the "
                   "same "
                   "since 2006."},
             Sheet{"dacia-bigster", 1812, 2702, 854, 1015, 10.97, "Dacia Poland, Bigster brochure, December 2025",
                   "10.97 m, curb to curb",
                   "https://cdn.group.renault.com/dac/pl/pdf/broszury/bigster-brochure.pdf.asset.pdf/5f71268df9.pdf\n"
                   "written down in github.com/xbodzio7/Dacia-Knowledge-Base, "
                   "data/master/configuration_attribute_values.csv\n"
                   "Lengths: Dacia's configurator, August 2026, PDF/Konfiguratory there. With front-wheel drive.\n"
                   "The length is given as 4.570 m, 1 mm less than wheelbase and overhangs make."},
             Sheet{"dacia-duster", 1813, 2657, 857, 829, 10.96, "Dacia Poland, Duster brochure, October 2025",
                   "10.96 m, curb to curb",
                   "https://cdn.group.renault.com/dac/pl/pdf/mini-broszury/new-duster-mini-brochure_2024.pdf.asset.pdf/"
                   "b2659c32d0.pdf\n"
                   "written down in github.com/xbodzio7/Dacia-Knowledge-Base, "
                   "data/master/configuration_attribute_values.csv\n"
                   "The third generation with front-wheel drive; 10.86 m in Dacia's configurator, August 2026.\n"
                   "The rear overhang is what the length of 4.343 m leaves: it is given as 828 mm."},
             Sheet{"dacia-jogger", 1784, 2898, 833, 819, 11.39, "Dacia Poland, Jogger brochure, December 2025",
                   "11.39 m, curb to curb",
                   "https://cdn.group.renault.com/dac/pl/pdf/broszury/jogger-brochure.pdf.asset.pdf/6b1235f90d.pdf\n"
                   "The same in github.com/xbodzio7/Dacia-Knowledge-Base, PDF/Broszury\n"
                   "Width: Dacia's configurator, August 2026, PDF/Konfiguratory there."},
             Sheet{"dacia-sandero", 1753, 2604, 833, 665, 10.64, "Dacia Poland, Sandero brochure, February 2026",
                   "10.64 m, curb to curb",
                   "https://cdn.group.renault.com/dac/pl/pdf/broszury/sandero-brochure.pdf.asset.pdf/b83cd5df5f.pdf\n"
                   "written down in github.com/xbodzio7/Dacia-Knowledge-Base, "
                   "data/master/configuration_attribute_values.csv\n"
                   "Width: Dacia's configurator, August 2026, PDF/Konfiguratory there. 1.853 m with mirrors folded."},
             Sheet{
                 "dacia-spring", 1583, 2423, 683, 595, 9.63, "Dacia Poland, Spring brochure, February 2026",
                 "9.63 m, curb to curb (of the wheels)",
                 "https://cdn.group.renault.com/dac/pl/pdf/broszury/new-spring-brochure.pdf.asset.pdf/acdd19cd55.pdf\n"
                 "written down in github.com/xbodzio7/Dacia-Knowledge-Base, "
                 "data/imports/spring_technical_20260219.csv\n"
                 "The width is without mirrors."},
             Sheet{"hyundai-ioniq-5", 1890, 3000, 845, 790, 12.0, "Hyundai Indonesia, e-brochure, Ioniq 5",
                   "12 m, curb or wall not said",
                   "The e-brochure of Hyundai in Indonesia, written down in github.com/judahdski/hyundai-ebrochure,\n"
                   "src/assets/data/car_detail_list/ioniq5Detail.js\n"
                   "Circle, and that the width is without mirrors: EVKX.net, Ioniq 5 Long Range AWD,\n"
                   "github.com/evkx/evkx.github.io, "
                   "content/models/hyundai/ioniq_5/Ioniq_5_Long_Range_AWD/specifications.md"},
             Sheet{"hyundai-ioniq-6", 1880, 2950, 850, 1055, 2 * 5.91,
                   "Hyundai Thailand, Ioniq 6 leaflet, October 2025", "radius 5.91 m, curb or wall not said",
                   "https://www.hyundai.com/content/dam/hyundai/th/en/data/marketing/brochure/product/ioniq6/"
                   "IONIQ6-A4%20LEAFLET_OCT2025.pdf\n"
                   "written down in github.com/bokoboss/thai-vehicle-engineering-db,\n"
                   "data/curation/manifests/wave1/hyundai_ioniq6_exclusive_revision_2024_v1.json"},
             Sheet{"hyundai-palisade", 1975, 2900, 945, 1135, 38.7 * foot, "Hyundai Indonesia, e-brochure, Palisade",
                   "38.7 ft, curb or wall not said",
                   "The e-brochure of Hyundai in Indonesia, written down in github.com/judahdski/hyundai-ebrochure,\n"
                   "src/assets/data/car_detail_list/palisadeDetail.js\n"
                   "Circle: Motor Trend (USA), May 2020, on the model of 2020,\n"
                   "https://issuhub.com/view/index/22719?pageIndex=39"},
             Sheet{"hyundai-santa-fe", 1900, 2765, 945, 1075, 11.4, "Hyundai Indonesia, e-brochure, Santa Fe",
                   "11.40 m, curb or wall not said",
                   "The e-brochure of Hyundai in Indonesia, written down in github.com/judahdski/hyundai-ebrochure,\n"
                   "src/assets/data/car_detail_list/santaFeDetail.js\n"
                   "The fourth generation. Circle: carspecslab, "
                   "https://www.carspecslab.com/hyundai/santa-fe/turning-circle"},
             Sheet{"hyundai-staria", 1997, 3273, 910, 1070, 2 * 5.97, "Hyundai Thailand, Staria MY25 brochure, 2024",
                   "radius 5.97 m, curb or wall not said",
                   "https://www.hyundai.com/content/dam/hyundai/th/en/data/marketing/brochure/product/staria/"
                   "STARIA_MY25-BROCHURE_4pages_Nov2024.pdf\n"
                   "written down in github.com/bokoboss/thai-vehicle-engineering-db,\n"
                   "data/curation/manifests/wave2b/hyundai_staria_premium_my2025_v1.json"},
             Sheet{"kia-ev3", 1850, 2680, 815, 815, 10.4, "Kia Europe, press release on the EV3, 2024",
                   "10.4 m, curb to curb",
                   "https://prod2-press.kia.com/eu/en/home/media-resouces/press-releases/2024/Kia-EV3.html\n"
                   "written down in github.com/FabienD/swept-path, data/vehicles.json\n"
                   "The length is given as 4.300 m, 10 mm less than wheelbase and overhangs make."},
             Sheet{"kia-ev5", 1875, 2750, 910, 950, 11.7, "Kia Australia, EV5 brochure", "11.7 m, curb to curb",
                   "https://www.kia.com/content/dam/kwcms/au/en/images/pdf/ev5/kia-ev5-brochure.pdf\n"
                   "written down in github.com/FabienD/swept-path, data/vehicles.json"},
             Sheet{"lexus-lbx", 1825, 2580, 860, 750, 2 * 5.2, "Lexus UK, LBX Tech Specs, July 2024",
                   "radius 5.2 m, curb to curb",
                   "https://media.lexus.co.uk/wp-content/uploads/sites/3/pdf/240723-LBX-Tech-Specs.pdf\n"
                   "written down in github.com/FabienD/swept-path, data/vehicles.json\n"
                   "The rear overhang is what the length of 4.190 m leaves: it is given as 740 mm.\n"
                   "The width is the sheet's with mirrors folded, so the body is no wider."},
             Sheet{"lexus-nx", 1865, 2690, 1007, 963, 2 * 5.8, "Lexus UK, NX Tech Specs, August 2024",
                   "radius 5.8 m, curb to curb",
                   "https://media.lexus.co.uk/wp-content/uploads/sites/3/pdf/240809-NX-Tech-Specs.pdf\n"
                   "written down in github.com/FabienD/swept-path, data/vehicles.json\n"
                   "The NX 450h+. The width is the sheet's with mirrors folded, so the body is no wider."},
             Sheet{"mazda-cx-3", 1765, 2570, 910, 795, 2 * 5.3,
                   "Motor Fan, Mazda's CX-3, CX-30, CX-5 and CX-4 compared", "radius 5.3 m, curb or wall not said",
                   "https://motor-fan.jp/mf/article/2845/\n"
                   "Circle: Web Cartop, September 2019, https://webcartop.jp/2019/09/428207"},
             Sheet{"mazda-cx-30", 1795, 2655, 915, 825, 2 * 5.3,
                   "Motor Fan, Mazda's CX-3, CX-30, CX-5 and CX-4 compared", "radius 5.3 m, curb or wall not said",
                   "https://motor-fan.jp/mf/article/2845/\n"
                   "Circle: Web Cartop, September 2019, https://webcartop.jp/2019/09/428207"},
             Sheet{"mazda-cx-5", 1840, 2700, 945, 900, 2 * 5.5,
                   "Motor Fan, Mazda's CX-3, CX-30, CX-5 and CX-4 compared", "radius 5.5 m, curb or wall not said",
                   "https://motor-fan.jp/mf/article/2845/\n"
                   "Circle: clicccar, December 2016, https://clicccar.com/2016/12/09/424822\n"
                   "The second generation."},
             Sheet{"mazda-mx-5", 1735, 2310, 760, 845, 2 * 4.7, "Mazda Thailand, MX-5 35th Anniversary, specification",
                   "radius 4.7 m, curb to curb",
                   "https://www.mazda.co.th/th/cars/mazda-mx5-35th/spec\n"
                   "written down in github.com/bokoboss/thai-vehicle-engineering-db,\n"
                   "data/curation/manifests/wave1/mazda_mx5_35ae_rf_at_release_2025_v1.json\n"
                   "The width is without wheel arch mouldings, the length without plate holder."},
             Sheet{"renault-master", 2070, 4332, 869, 1024, 15.7, "Renault, technical brochure, Master, July 2023",
                   "15.7 m, curb to curb",
                   "The brochure of Renault in France, written down in github.com/billiet-cadart/van,\n"
                   "docs/dimensions-l3h2.md\n"
                   "The long van, L3H2 with front-wheel drive. The brochure calls its diameters radii; 16.2 m wall to "
                   "wall."},
             Sheet{"skoda-octavia", 1829, 2686, 910, 1094, 10.4, "auto-data.net, Skoda Octavia IV 2.0 TDI (150 Hp) DSG",
                   "10.4 m, curb or wall not said",
                   "https://www.auto-data.net/en/skoda-octavia-iv-2.0-tdi-150hp-dsg-38011\n"
                   "written down in github.com/uoe-agents/IGP2, igp2/core/agentstate.py\n"
                   "Circle: carspecslab, https://carspecslab.com/skoda/fabia/turning-circle (10.2 m on its page of the "
                   "Superb)\n"
                   "The length is given as 4.689 m, 1 mm less than wheelbase and overhangs make."},
             Sheet{"tesla-model-3", 1850, 2875, 868, 977, 11.7, "Tesla, Model 3 Owner's Manual, Thailand, 2024+",
                   "11.7 m, curb to curb",
                   "https://www.tesla.com/ownersmanual/model3/en_th/\n"
                   "written down in github.com/bokoboss/thai-vehicle-engineering-db,\n"
                   "data/curation/manifests/wave1/tesla_model3_premium_lr_rwd_2024plus_v1.json"},
             Sheet{"tesla-model-s", 1987, 2960, 961, 1100, 12.3, "Tesla, Model S Owner's Manual, China",
                   "12.3 m, curb or wall not said",
                   "https://tesla.com/ownersmanual/models/en_cn/GUID-91E5877F-3CD2-4B3B-B2B8-B5DB4A6C0A05.html\n"
                   "Circle: EVKX.net, Model S Plaid,\n"
                   "github.com/evkx/evkx.github.io, content/models/tesla/model_s/Model_S_Plaid/specifications.md"},
             Sheet{"tesla-model-y", 1920, 2890, 889, 1011, 12.13, "Tesla, Model Y Owner's Manual, Thailand, 2025+",
                   "12.13 m, curb to curb",
                   "https://www.tesla.com/ownersmanual/modely/en_th/GUID-1E76B638-7B12-4D9A-8767-94B7F1E92A0E.html\n"
                   "https://www.tesla.com/ownersmanual/modely/en_th/GUID-E414862C-CFA1-4A0B-9548-BE21C32CAA58.html\n"
                   "written down in github.com/bokoboss/thai-vehicle-engineering-db,\n"
                   "data/curation/manifests/wave1/tesla_model_y_premium_lr_rwd_19_2025plus_v1.json\n"
                   "The length is without plate bracket."},
         }) {
        cars.push_back(read_off(sheet));
    }
    return cars;
}

}  // namespace snug
