// Taking it away: a link, a command, files.
import type { EntryAnswer, FewestAnswer } from "snug";
import { byId, html, setText } from "./dom";
import { asPng, rangesCsv, save, standalone } from "./download";
import { commandLine, plain, toLink, type Inputs } from "./inputs";

export function createShare(inputs: () => Inputs, answer: () => EntryAnswer | FewestAnswer | null) {
    const picture = byId<SVGSVGElement>("drawing");
    const say = (sentence: string) => setText(byId("shared"), sentence);
    const click = (id: string, what: () => void) => byId(id).addEventListener("click", what);

    const copy = async (text: string, what: string) => {
        try {
            await navigator.clipboard.writeText(text);
            say(`${what} copied.`);
        } catch {
            say(`Copy this: ${text}`);
        }
    };
    click("copy-link", () => void copy(`${location.href.split("#")[0]}#${toLink(inputs())}`, "Link"));
    click("copy-command", () => void copy(commandLine(inputs()), "Command"));

    const file = (ending: string, content: Blob) => {
        const { car, length, width } = inputs();
        save(`snug-${car.name ?? "own"}-${plain(length)}x${plain(width)}.${ending}`, content);
    };
    const answerFile = (ending: string, type: string, text: (found: EntryAnswer | FewestAnswer) => string) => {
        const found = answer();
        if (!found) say("The answer is still being searched for.");
        else file(ending, new Blob([text(found)], { type }));
    };
    click("save-svg", () => file("svg", new Blob([standalone(picture)], { type: "image/svg+xml" })));
    click("save-png", () => asPng(picture).then((png) => file("png", png), (error: unknown) => say(String(error))));
    click("save-json", () => answerFile("json", "application/json", (found) => JSON.stringify(found, null, 2) + "\n"));
    click("save-csv", () => {
        if (inputs().strategy === "fewest") say("CSV lists ranges of headings, but all maneuvers have none; take JSON.");
        else answerFile("csv", "text/csv", (found) => rangesCsv(found.entry_ranges));
    });

    // An option and its value stay on one line.
    const command = byId("command");
    const show = () => {
        const line = commandLine(inputs());
        if (command.textContent === line) return;
        command.replaceChildren(...line.split(/(--\S+ \S+)/).map((part) => (part.startsWith("--") ? html("span", {}, part) : part)));
    };
    return { show };
}
