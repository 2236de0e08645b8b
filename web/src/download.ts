// Files made from the picture and the answer.
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

/** The drawing as a file of its own: what the style sheet says is written into the elements, the handles are left out. */
export function standalone(drawing: SVGSVGElement): string {
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
    copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
    copy.setAttribute("width", String(Math.round(width)));
    copy.setAttribute("height", String(Math.round(height)));
    return new XMLSerializer().serializeToString(copy);
}

export async function asPng(drawing: SVGSVGElement): Promise<Blob> {
    const { width, height } = drawing.getBoundingClientRect();
    const image = new Image();
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(standalone(drawing))}`;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = Math.round(2 * width);
    canvas.height = Math.round(2 * height);
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
