// A place from a file: a scene, or a case of TPCAP, dropped on the page or chosen.
import type { Scene, Snug } from "snug";
import { byId } from "./dom";

const largest = 1_000_000; // [bytes], as the command's

interface Listener {
    opened(scene: Scene): void;
    failed(sentence: string): void;
}

export function createSceneFile(snug: Snug, listener: Listener) {
    const open = async (file: File) => {
        // The name goes into sentences: only what can be a name's.
        const name = file.name.replace(/[^\w .()-]/g, "_").slice(0, 80) || "file";
        try {
            if (file.size > largest) throw new Error(`${name}: is larger than 1 MB`);
            listener.opened(snug.readScene(await file.text(), name));
        } catch (error) {
            listener.failed(error instanceof Error ? error.message : String(error));
        }
    };
    const stage = document.documentElement;
    stage.addEventListener("dragover", (event) => {
        if (!event.dataTransfer?.types.includes("Files")) return;
        event.preventDefault();
        stage.dataset.dropping = "";
    });
    for (const end of ["dragleave", "drop"]) stage.addEventListener(end, () => delete stage.dataset.dropping);
    stage.addEventListener("drop", (event) => {
        const file = event.dataTransfer?.files[0];
        if (!file) return;
        event.preventDefault();
        void open(file);
    });
    const chosen = byId<HTMLInputElement>("scene-file");
    chosen.addEventListener("change", () => {
        const file = chosen.files?.[0];
        if (file) void open(file);
        chosen.value = ""; // the same file may be chosen again
    });
}
