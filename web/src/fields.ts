// The fields for numbers: what is typed becomes an input, or a sentence beside the field that says what is wrong.
import { byId, html, set, setText } from "./dom";
import { carTrouble, fields as table, fieldValue, parseNumber, plain, withField, within, type Inputs, type NumberField } from "./inputs";

/** Which fields stand where. */
const places: Record<string, NumberField[]> = {
    "car-fields": ["car-width", "car-front", "car-rear", "car-wheelbase", "car-steer", "car-corner"],
    "sheet-fields": ["front-overhang", "turning-circle"],
    "slot-fields": ["length", "width"],
    "street-fields": ["angle", "road"],
    "neighbour-fields": ["front-setback", "rear-setback"],
    "pose-fields": ["x", "y", "turn"],
    "driving-fields": ["clearance", "heading"],
};

export function createFields(inputs: () => Inputs, change: (next: Inputs) => void) {
    const fields = new Map<NumberField, { input: HTMLInputElement; error: HTMLElement }>();
    /** What the field showed last: a complaint stays until that changes. */
    const filled = new Map<NumberField, number | null>();

    const complain = (field: NumberField, sentence: string) => {
        const { input, error } = fields.get(field)!;
        setText(error, sentence);
        set(input, { "aria-invalid": sentence ? "true" : null });
        const hidden = input.closest("details");
        if (sentence && hidden) hidden.open = true;
    };

    const fill = (field: NumberField) => {
        const { input } = fields.get(field)!;
        const value = fieldValue(inputs(), field);
        if (document.activeElement === input || (input.getAttribute("aria-invalid") && filled.get(field) === value)) return;
        filled.set(field, value);
        input.value = value === null ? "" : plain(value, table[field].unit === "°" ? 3 : 4);
        complain(field, "");
    };

    /** The number goes in, unless the car as a whole would be none. */
    const put = (field: NumberField, value: number | null) => {
        const next = withField(inputs(), field, value);
        const wrong = next.car !== inputs().car && carTrouble(next);
        complain(field, wrong ? wrong.sentence : "");
        filled.set(field, wrong ? fieldValue(inputs(), field) : value);
        if (!wrong) change(next);
    };

    const typed = (field: NumberField, text: string) => {
        if (table[field].empty && text.trim() === "") {
            put(field, null);
            return;
        }
        const value = parseNumber(field, text);
        if (typeof value === "number") put(field, value);
        else {
            complain(field, value);
            filled.set(field, fieldValue(inputs(), field));
        }
    };

    const add = (field: NumberField, parent: string) => {
        const { title, unit, empty } = table[field];
        const error = html("span", { class: "error", id: `${field}-error`, role: "alert" });
        const input = html("input", {
            id: field,
            name: field,
            type: "text",
            inputmode: "decimal",
            maxlength: 40,
            spellcheck: "false",
            placeholder: empty,
            "aria-describedby": error.id,
        });
        const place = html("div", { class: "number" }, html("label", { for: field }, title), input, error);
        if (field === "heading") place.dataset.for = "entry";
        byId(parent).append(place);
        input.addEventListener("input", () => typed(field, input.value));
        input.addEventListener("blur", () => {
            if (input.getAttribute("aria-invalid") !== "true") fill(field);
        });
        input.addEventListener("keydown", (event) => {
            const step = { ArrowUp: 1, ArrowDown: -1 }[event.key];
            const value = fieldValue(inputs(), field);
            if (!step || value === null) return;
            event.preventDefault();
            const by = (unit === "°" ? 0.1 : 0.01) * (event.shiftKey ? 10 : 1);
            const next = within(field, Number((value + step * by).toFixed(6)));
            input.value = plain(next);
            put(field, next);
        });
        fields.set(field, { input, error });
    };
    for (const [parent, list] of Object.entries(places)) for (const field of list) add(field, parent);

    /** The values into the fields, unless something is being typed there, or was and is still explained. */
    const show = () => {
        for (const field of fields.keys()) fill(field);
    };
    return { show, complain };
}
