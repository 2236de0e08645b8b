// What is chosen rather than typed: the car, and the ways to park it.
import type { Car } from "snug";
import { byId, html, setText } from "./dom";
import type { Inputs } from "./inputs";

const titles: Record<string, string> = {
    "mid-size": "Mid-sized car",
    "renault-zoe": "Renault ZOE",
    "vw-transporter": "VW Transporter",
    "mercedes-amg-gt": "Mercedes-AMG GT",
    "kia-ev3": "Kia EV3",
    "kia-ev5": "Kia EV5",
    "lexus-lbx": "Lexus LBX",
    "lexus-nx": "Lexus NX",
    "mazda-mx-5": "Mazda MX-5",
    "skoda-octavia": "Škoda Octavia",
};
const titleOf = (name: string) => titles[name] ?? name.split("-").map((word) => word.charAt(0).toUpperCase() + word.slice(1)).join(" ");

const round = (value: number) => Number(value.toFixed(2));
/** A slot or bay as wide and deep as they usually are for this car, and wider by the distance to keep. */
export function usualSlot({ front, rear, width }: Car, angle: number, clearance: number) {
    const [long, wide] = [front + rear + 2 * clearance, width + 2 * clearance];
    return angle === 0 ? { length: round(long + 0.2 * (front + rear)), width: round(wide + 0.25) } : { length: round(long + 0.6), width: round(wide + 0.73) };
}
const angles: Record<string, number> = { parallel: 0, angled: 60, perpendicular: 90 };
export const kindOf = (angle: number) => (angle === 0 ? "parallel" : angle === 90 ? "perpendicular" : "angled");
function withKind(inputs: Inputs, kind: string): Inputs {
    const angle = angles[kind]!;
    const same = (inputs.angle === 0) === (angle === 0);
    return { ...inputs, angle, pose: null, scene: null, ...(same ? {} : usualSlot(inputs.car, angle, inputs.clearance)) };
}

/** Cars as they are listed. */
export interface CarGroup {
    title: string;
    cars: Car[];
}

export function createChoices(groups: CarGroup[], inputs: () => Inputs, change: (next: Inputs) => void) {
    const cars = byId<HTMLSelectElement>("car");
    cars.append(
        ...groups.map(({ title, cars }) =>
            html("optgroup", { label: title }, ...cars.map((car) => html("option", { value: car.name }, titleOf(car.name!)))),
        ),
        html("option", { value: "" }, "My own dimensions"),
    );
    cars.addEventListener("change", () => {
        const car = groups.flatMap((group) => group.cars).find((one) => one.name === cars.value);
        if (car) change({ ...inputs(), car });
        else {
            const { name: _, ...own } = inputs().car;
            change({ ...inputs(), car: own });
            byId<HTMLDetailsElement>("dimensions").open = true;
        }
    });
    const form = byId("inputs");
    form.addEventListener("submit", (event) => event.preventDefault());
    document.querySelector("main")!.addEventListener("change", (event) => {
        const { name, value, type } = event.target as HTMLInputElement;
        if (type !== "radio") return;
        if (name === "kind") change(withKind(inputs(), value));
        else change({ ...inputs(), [name]: value, ...(name === "way" || name === "enter" || name === "side" ? { pose: null } : {}) });
    });

    const show = () => {
        const now = inputs();
        cars.value = now.car.name ?? "";
        const kind = now.scene ? "" : kindOf(now.angle);
        for (const radio of document.querySelectorAll<HTMLInputElement>("input[type=radio]")) {
            const name = radio.name as "side";
            radio.checked = radio.value === (radio.name === "kind" ? kind : now[name]);
        }
        const bay = now.mode === "street" && now.angle > 0;
        setText(byId("in-tail"), bay ? "tail first" : "backward");
    };
    return { show };
}
