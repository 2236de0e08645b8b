// The page: what is set goes to the solver each frame, and its answer into words, numbers and the picture.
import type { Maneuver, MaxSteerRun, Snug } from "snug";
import { createAnswers } from "./answers";
import { createChoices } from "./choices";
import { byId, set, setText } from "./dom";
import { createDrawing } from "./drawing";
import { createFields } from "./fields";
import { clamp, entryPose, track } from "./geometry";
import { drivingOf, fromLink, slotOf, toLink, within, type Inputs } from "./inputs";
import { later } from "./later";
import { createMaps } from "./maps";
import { createPlayer } from "./player";
import { asker } from "./questions";
import { createShare } from "./share";
import { createShorter } from "./shorter";
import { compile, start } from "./solver";
import { sayAnswer, sayHeading } from "./words";

function run(snug: Snug, module: WebAssembly.Module) {
    const catalogue = snug.cars();
    /** What a link leaves out. */
    const usual: Inputs = {
        car: catalogue.find((car) => car.name === "renault-zoe")!,
        length: 4.9,
        width: 2.0,
        side: "right",
        clearance: 0,
        enter: "backward",
        strategy: "max-steer",
        heading: null,
    };
    let inputs = usual;
    const now = () => inputs;

    let due = false;
    const refresh = () => {
        if (due) return;
        due = true;
        requestAnimationFrame(frame);
    };
    /** A heading belongs to its question: another question begins at the best one again. */
    const change = (next: Inputs) => {
        const sameQuestion = (Object.keys(usual) as (keyof Inputs)[]).every((key) => key === "heading" || next[key] === inputs[key]);
        inputs = sameQuestion || next.heading !== inputs.heading ? next : { ...next, heading: null };
        refresh();
    };

    const drawing = createDrawing(byId<SVGSVGElement>("drawing"), {
        length: (value) => change({ ...inputs, length: within("length", value) }),
        width: (value) => change({ ...inputs, width: within("width", value) }),
        heading: (value) => change({ ...inputs, heading: value }),
        released: () => {
            askRanges(inputs);
            refresh();
        },
    });
    const player = createPlayer((pose, steer) => drawing.showCar(pose, steer));
    const fields = createFields(now, change);
    const choices = createChoices(catalogue, now, change);
    const questions = asker(module);
    const shorter = createShorter(questions);
    const { answers, frameTimes, ask, askRanges, final } = createAnswers(snug, questions, {
        changed: refresh,
        settled: () => shorter.ask(inputs, final(inputs)?.direction_changes),
        failed: (sentence) => trouble(sentence),
        busy: () => drawing.busy() || maps.busy(),
    });
    const maps = createMaps(questions, (extraLength, extraWidth) => {
        const { car } = inputs;
        change({
            ...inputs,
            length: within("length", car.front + car.rear + extraLength),
            width: within("width", car.width + extraWidth),
        });
    });
    const share = createShare(now, () => final(inputs));
    const swept = byId<HTMLInputElement>("swept");
    swept.addEventListener("change", refresh);
    byId("best").addEventListener("click", () => {
        change({ ...inputs, heading: null });
        byId("answer").focus({ preventScroll: true }); // the button goes, the keyboard's place stays
    });

    const soonLink = later(300);
    function frame() {
        due = false;
        try {
            if (ask(inputs)) shorter.wait();
            present(inputs.heading === null ? null : snug.maxSteer(inputs.car, slotOf(inputs), inputs.heading, drivingOf(inputs)));
            trouble("");
        } catch (error) {
            trouble(error instanceof Error ? error.message : String(error));
            return;
        }
        fields.show();
        choices.show();
        maps.show(inputs);
        share.show();
        soonLink(() => {
            const mine = `#${toLink(inputs)}`;
            if (location.hash !== mine) history.replaceState(null, "", mine);
        });
    }

    let loaded: Maneuver | undefined | null = null;
    function present(run: MaxSteerRun | null) {
        const { car, length, width, clearance, side, strategy } = inputs;
        const forward = inputs.enter === "forward";
        const best = (strategy === "fewest" && answers.fewest?.maneuver) || answers.entry?.maneuver;
        const shown = run ? run.maneuver : best;
        const turned = (side === "left" ? -1 : 1) * (forward ? -1 : 1) * (shown?.entry.heading ?? 0);
        const heading = inputs.heading ?? clamp(turned, 0, Math.PI / 2);
        const way = shown ? track(shown, side) : null;
        drawing.render({
            car,
            length,
            width,
            left: side === "left",
            forward,
            clearance,
            heading,
            ranges: answers.fewest && !run ? [] : answers.ranges, // full steering's
            track: way,
            parked: run ? run.outcome === "parked" : true,
            swept: swept.checked,
        });
        if (loaded !== shown || !shown) {
            loaded = shown;
            player.load(shown && way ? { car, maneuver: shown, track: way } : null);
        } else player.place();
        if (!shown) drawing.showCar(entryPose(car, length, heading, forward, clearance), 0);
        sayAnswer(snug, inputs, answers, shown);
        sayHeading(inputs, answers, shown, run, heading);
    }

    // What is wrong with a link is said next to the field it means, else at the top.
    let complaints: string[] = [];
    function trouble(sentence: string) {
        const all = [...complaints, sentence].filter(Boolean).join(" ");
        setText(byId("trouble"), all);
        set(byId("trouble"), { hidden: all ? null : "" });
    }
    byId("inputs").addEventListener("input", () => (complaints = []));
    const follow = () => {
        const link = fromLink(location.hash.slice(1), usual, catalogue);
        inputs = link.inputs;
        complaints = link.complaints.filter(({ field }) => !field).map(({ sentence }) => sentence);
        frame();
        for (const { field, sentence } of link.complaints) if (field) fields.complain(field, sentence);
    };
    window.addEventListener("hashchange", follow);

    follow();
    document.documentElement.dataset.ready = String(Math.round(performance.now()));
    // For the tests of the page.
    Object.assign(window, { snugPage: { snug, frameTimes, inputs: now, answer: () => final(inputs) } });
}

async function begin() {
    if (typeof WebAssembly !== "object") throw new Error("This page needs a browser with WebAssembly; any from 2022 on has it.");
    let module: WebAssembly.Module;
    let snug: Snug;
    try {
        module = await compile();
        snug = await start(module);
    } catch (error) {
        throw new Error(`The solver could not be started here: ${error instanceof Error ? error.message : String(error)}. Any browser from 2022 on runs it.`);
    }
    run(snug, module);
}

begin().catch((error: unknown) => {
    const trouble = byId("trouble");
    document.documentElement.dataset.broken = "";
    setText(trouble, error instanceof Error ? error.message : String(error));
    trouble.hidden = false;
});
