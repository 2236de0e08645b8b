// What is chosen rather than typed: the car, and the ways to park it.
import type { Car } from "snug";
import { byId, html } from "./dom";
import type { Inputs } from "./inputs";

const titles: Record<string, string> = {
    "mid-size": "Mid-sized car",
    "renault-zoe": "Renault ZOE",
    "opel-corsa": "Opel Corsa",
    "vw-transporter": "VW Transporter",
    "mercedes-amg-gt": "Mercedes-AMG GT",
};

export function createChoices(catalogue: Car[], inputs: () => Inputs, change: (next: Inputs) => void) {
    const cars = byId<HTMLSelectElement>("car");
    cars.append(
        ...catalogue.map((car) => html("option", { value: car.name }, titles[car.name!] ?? car.name!)),
        html("option", { value: "" }, "My own dimensions"),
    );
    cars.addEventListener("change", () => {
        const car = catalogue.find((one) => one.name === cars.value);
        if (car) change({ ...inputs(), car });
        else {
            const { name: _, ...own } = inputs().car;
            change({ ...inputs(), car: own });
            byId<HTMLDetailsElement>("dimensions").open = true;
        }
    });
    const form = byId("inputs");
    form.addEventListener("submit", (event) => event.preventDefault());
    form.addEventListener("change", (event) => {
        const { name, value, type } = event.target as HTMLInputElement;
        if (type === "radio") change({ ...inputs(), [name]: value });
    });

    const show = () => {
        const now = inputs();
        cars.value = now.car.name ?? "";
        for (const name of ["side", "enter", "strategy"] as const)
            for (const radio of form.querySelectorAll<HTMLInputElement>(`input[name=${name}]`)) radio.checked = radio.value === now[name];
    };
    return { show };
}
