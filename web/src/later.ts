/** Does the last thing it was given, once nothing newer has come for some milliseconds. */
export const later = (milliseconds: number) => {
    let timer = 0;
    return (what: () => void, after = milliseconds) => {
        clearTimeout(timer);
        timer = window.setTimeout(what, after);
    };
};
