// The fields for numbers: what is typed becomes an input, or a sentence beside the field that says what is wrong.
import { byId, html, set, setText } from "./dom";
import { carNumberFields, fieldValue, parseNumber, plain, withField, within, type Inputs, type NumberField } from "./inputs";

const titles: Record<NumberField, string> = {
    length: "Length [m]",
    width: "Width [m]",
    clearance: "Clearance [m]",
    heading: "Heading [°]",
    "car-width": "Width [m]",
    "car-front": "Front [m]",
    "car-rear": "Rear [m]",
    "car-wheelbase": "Wheelbase [m]",
    "car-steer": "Steering [°]",
};

export function createFields(inputs: () => Inputs, change: (next: Inputs) => void) {
    const fields = new Map<NumberField, { input: HTMLInputElement; error: HTMLElement }>();
    /** What the field showed last: a complaint stays until that changes. */
    const filled = new Map<NumberField, number | null>();

    const complain = (field: NumberField, sentence: string) => {
        const { input, error } = fields.get(field)!;
        setText(error, sentence);
        set(input, { "aria-invalid": sentence ? "true" : null });
        if (sentence && field.startsWith("car-")) byId<HTMLDetailsElement>("dimensions").open = true;
    };

    const fill = (field: NumberField) => {
        const { input } = fields.get(field)!;
        const value = fieldValue(inputs(), field);
        if (document.activeElement === input || (input.getAttribute("aria-invalid") && filled.get(field) === value)) return;
        filled.set(field, value);
        input.value = value === null ? "" : plain(value, field === "heading" ? 3 : 4);
        complain(field, "");
    };

    const typed = (field: NumberField, text: string) => {
        if (field === "heading" && text.trim() === "") {
            complain(field, "");
            change({ ...inputs(), heading: null });
            return;
        }
        const value = parseNumber(field, text);
        complain(field, typeof value === "string" ? value : "");
        filled.set(field, typeof value === "number" ? value : fieldValue(inputs(), field));
        if (typeof value === "number") change(withField(inputs(), field, value));
    };

    const add = (field: NumberField, parent: string) => {
        const error = html("span", { class: "error", id: `${field}-error`, role: "alert" });
        const input = html("input", {
            id: field,
            name: field,
            type: "text",
            inputmode: "decimal",
            maxlength: 40,
            spellcheck: "false",
            "aria-describedby": error.id,
        });
        byId(parent).append(html("div", { class: "number" }, html("label", { for: field }, titles[field]), input, error));
        input.addEventListener("input", () => typed(field, input.value));
        input.addEventListener("blur", () => {
            if (input.getAttribute("aria-invalid") !== "true") fill(field);
        });
        input.addEventListener("keydown", (event) => {
            const step = { ArrowUp: 1, ArrowDown: -1 }[event.key];
            const value = fieldValue(inputs(), field);
            if (!step || value === null) return;
            event.preventDefault();
            const by = (field === "heading" || field === "car-steer" ? 0.1 : 0.01) * (event.shiftKey ? 10 : 1);
            complain(field, "");
            const next = within(field, Number((value + step * by).toFixed(6)));
            input.value = plain(next);
            change(withField(inputs(), field, next));
        });
        fields.set(field, { input, error });
    };
    for (const field of carNumberFields) add(field, "car-fields");
    for (const field of ["length", "width"] as const) add(field, "slot-fields");
    for (const field of ["clearance", "heading"] as const) add(field, "driving-fields");
    set(fields.get("heading")!.input, { placeholder: "best" });

    /** The values into the fields, unless something is being typed there, or was and is still explained. */
    const show = () => {
        for (const field of fields.keys()) fill(field);
    };
    return { show, complain };
}
