// Files made from the picture and the answer.
import { svg } from "./dom";

export function save(name: string, content: Blob) {
    const address = URL.createObjectURL(content);
    const link = document.createElement("a");
    link.href = address;
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

const styled = ["fill", "fill-opacity", "fill-rule", "stroke", "stroke-width", "stroke-opacity", "stroke-dasharray", "stroke-linejoin",
    "opacity", "font-family", "font-size", "font-weight", "vector-effect", "display"];

export interface Caption {
    title: string;
    answer: string;
    /** The moves: arrow, how, angle, length, until. */
    rows: string[][];
}

/** Text below the drawing: what was asked, what came out, and the moves in columns. */
function captioned(caption: Caption, width: number, top: number) {
    const style = getComputedStyle(document.body);
    const [ink, paper] = [style.color, getComputedStyle(document.documentElement).backgroundColor];
    const parts: SVGElement[] = [];
    const write = (x: number, y: number, text: string, size: number, weight = 400) =>
        parts.push(svg("text", { x, y, fill: ink, "font-family": "DejaVu Sans, sans-serif", "font-size": size, "font-weight": weight }, text));
    write(16, top + 26, caption.answer, 15, 600);
    write(16, top + 46, caption.title, 12);
    const columns = Math.max(1, Math.floor(width / 330));
    const perColumn = Math.ceil(caption.rows.length / columns);
    caption.rows.forEach(([, how, angle, far, until], i) => {
        const x = 16 + Math.floor(i / perColumn) * ((width - 32) / columns);
        write(x, top + 74 + (i % perColumn) * 34, `${i + 1}. ${how}, ${angle}, ${far}`, 12);
        write(x + 16, top + 89 + (i % perColumn) * 34, until ?? "", 11);
    });
    const height = top + (perColumn > 0 ? 74 + perColumn * 34 : 60);
    return { height, parts: [svg("rect", { x: 0, y: top, width, height: height - top, fill: paper }), ...parts] };
}

/** The drawing as a file of its own: what the style sheet says is written into the elements, the handles are left out. */
export function standalone(drawing: SVGSVGElement, caption: Caption): string {
    const copy = drawing.cloneNode(true) as SVGSVGElement;
    const originals = drawing.querySelectorAll<SVGElement>("*");
    copy.querySelectorAll<SVGElement>("*").forEach((element, i) => {
        const style = getComputedStyle(originals[i]!);
        for (const property of styled) {
            const value = style.getPropertyValue(property);
            if (value && value !== "none 0px") element.setAttribute(property, value);
        }
        for (const name of ["class", "role", "tabindex"]) element.removeAttribute(name);
    });
    copy.querySelectorAll("[data-grip]").forEach((grip) => grip.remove());
    const { width, height } = drawing.getBoundingClientRect();
    for (const name of ["class", "id", "role", "aria-labelledby", "aria-describedby"]) copy.removeAttribute(name);
    const below = captioned(caption, Math.round(width), Math.round(height));
    copy.append(...below.parts);
    copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
    copy.setAttribute("viewBox", `0 0 ${Math.round(width)} ${below.height}`);
    copy.setAttribute("width", String(Math.round(width)));
    copy.setAttribute("height", String(below.height));
    return new XMLSerializer().serializeToString(copy);
}

export async function asPng(drawing: SVGSVGElement, caption: Caption): Promise<Blob> {
    const image = new Image();
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(standalone(drawing, caption))}`;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = 2 * image.naturalWidth;
    canvas.height = 2 * image.naturalHeight;
    canvas.getContext("2d")!.drawImage(image, 0, 0, canvas.width, canvas.height);
    return new Promise((resolve, reject) =>
        canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("the picture could not be made"))), "image/png"),
    );
}

/** Entry ranges as the command prints them with --format csv. */
export function rangesCsv(ranges: { heading_min: number; heading_max: number; direction_changes: number; subrange: number }[]) {
    const rows = ranges.map((r) => [r.heading_min, r.heading_max, r.direction_changes, r.subrange].join(","));
    return ["heading_min,heading_max,direction_changes,subrange", ...rows].join("\n") + "\n";
}
