// Taking it away: a link, a command, files.
import type { EntryAnswer, FewestAnswer, ParkAnswer } from "snug";
import { byId, html, setText } from "./dom";
import { asPng, rangesCsv, save, standalone, type Caption } from "./download";
import { holdsScene, plain, toLink, type Inputs } from "./inputs";

type Found = EntryAnswer | FewestAnswer | ParkAnswer;

/** `asCommand`: the same question on the command line. */
export function createShare(inputs: () => Inputs, answer: () => Found | null, asCommand: () => string) {
    const picture = () => byId<SVGSVGElement>(inputs().mode === "street" ? "street" : "drawing");
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
    click("copy-link", () => {
        const link = toLink(inputs());
        if (inputs().scene && !holdsScene(link)) say("This place is too large for a link; pass its file on.");
        else void copy(`${location.href.split("#")[0]}#${link}`, "Link");
    });
    click("copy-command", () => void copy(asCommand(), "Command"));

    /** What a picture says beside what it shows: the question, the answer and the moves. */
    const caption = (): Caption => {
        const text = (id: string) => byId(id).textContent ?? "";
        const rows = [...byId("moves").querySelectorAll("button")].map((row) => [...row.children].map((cell) => cell.textContent ?? ""));
        return { title: asCommand().replace(/^.*&& /, ""), answer: `${text("verdict")}: ${text("count")} ${text("count-unit")}. ${text("count-note")}`, rows };
    };

    const file = (ending: string, content: Blob) => {
        const { car, length, width, scene } = inputs();
        save(`snug-${car.name ?? "own"}-${scene ? "scene" : `${plain(length)}x${plain(width)}`}.${ending}`, content);
    };
    const answerFile = (ending: string, type: string, text: (found: Found) => string) => {
        const found = answer();
        if (!found) say("The answer is still being searched for.");
        else file(ending, new Blob([text(found)], { type }));
    };
    click("save-svg", () => file("svg", new Blob([standalone(picture(), caption())], { type: "image/svg+xml" })));
    click("save-png", () => asPng(picture(), caption()).then((png) => file("png", png), (error: unknown) => say(String(error))));
    click("save-json", () => answerFile("json", "application/json", (found) => JSON.stringify(found, null, 2) + "\n"));
    click("save-csv", () => {
        const found = answer();
        if (inputs().mode === "street" || inputs().strategy === "fewest") say("CSV lists ranges of headings, but all maneuvers have none; take JSON.");
        else answerFile("csv", "text/csv", () => (found && "entry_ranges" in found ? rangesCsv(found.entry_ranges) : ""));
    });

    // An option and its value stay on one line.
    const command = byId("command");
    const show = () => {
        const line = asCommand();
        if (command.textContent === line) return;
        command.replaceChildren(...line.split(/(--\S+ \S+)/).map((part) => (part.startsWith("--") ? html("span", {}, part) : part)));
    };
    return { show };
}
