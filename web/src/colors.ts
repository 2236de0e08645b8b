// One colour for each number of direction changes, bright for easy and dark for hard, in the drawing and on the maps.
const steps: [most: number, color: string, label: string][] = [
    [0, "#f2dc5c", "0"],
    [1, "#b9d65a", "1"],
    [2, "#76c66b", "2"],
    [3, "#3bb07d", "3"],
    [5, "#229488", "4–5"],
    [9, "#2a768e", "6–9"],
    [20, "#38568b", "10–20"],
    [49, "#42387a", "21–49"],
    [Infinity, "#3c1057", "50+"],
];

export const countColor = (changes: number) => steps.find(([most]) => changes <= most)![1];
export const legend = steps.map(([, color, label]) => ({ color, label }));

/** More than are counted: not impossible, which is hatched. */
export const moreColor = "#8d8791";
