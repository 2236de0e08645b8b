// Elements of the page and of drawings. Text is only ever set as text.
type Attributes = Record<string, string | number | null | undefined>;

const svgNamespace = "http://www.w3.org/2000/svg";

export function svg<K extends keyof SVGElementTagNameMap>(
    tag: K,
    attributes: Attributes = {},
    ...children: (Node | string)[]
): SVGElementTagNameMap[K] {
    const element = document.createElementNS(svgNamespace, tag);
    set(element, attributes);
    element.append(...children);
    return element;
}

export function html<K extends keyof HTMLElementTagNameMap>(
    tag: K,
    attributes: Attributes = {},
    ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
    const element = document.createElement(tag);
    set(element, attributes);
    element.append(...children);
    return element;
}

export function set(element: Element, attributes: Attributes) {
    for (const [name, value] of Object.entries(attributes)) {
        if (value === null || value === undefined) element.removeAttribute(name);
        else if (element.getAttribute(name) !== String(value)) element.setAttribute(name, String(value));
    }
}

export function byId<T extends Element = HTMLElement>(id: string): T {
    const element = document.getElementById(id);
    if (!element) throw new Error(`the page has no #${id}`);
    return element as unknown as T;
}

export function setText(element: Element, text: string) {
    if (element.textContent !== text) element.textContent = text;
}
