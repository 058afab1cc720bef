"""The hash chain of a study file, computed anew from its rows: trials/study/ledger written a second time, so that a
change of what is hashed cannot pass unseen. Knows nothing of the C++ code but the format."""
import hashlib
import sqlite3

# Lines of a text that no two runs share.
CLOCKS = ("begun", "onset", "started", "version", "machine", "question onset", "committed", "utc", "loop rate",
          "loop p999", "missed", "force bound", "within tolerance", "at cap", "felt before")


def sha256(text):
    return hashlib.sha256(text.encode()).hexdigest()


def shortest(value):
    """A double with the fewest digits that give it back, as C++'s {fmt} writes it: no ".0"."""
    if value is None:
        return "null"
    text = repr(float(value))
    return text[:-2] if text.endswith(".0") else text


def line(name, value):
    escaped = str(value).replace("\\", "\\\\").replace("\n", "\\n")
    return f"{name}={escaped}\n"


def session_text(row):
    return "".join([
        line("examinee", row["examinee"]), line("sitting", row["number"]), line("run mode", row["run_mode"]),
        line("started", row["started_utc"]), line("version", row["software_version"]), line("machine", row["machine"]),
        line("device", row["device"]), line("pseudo-haptic", row["pseudo_haptic"]), line("channel", row["channel"]),
        line("force scale", shortest(row["force_scale"])),
        line("seed", "entropy" if row["seed"] is None else row["seed"]),
        line("observer", "null" if row["observer"] is None else row["observer"])])


def trial_text(row):
    return "".join([
        line("trial", row["number"]), line("draw", row["draw"]), line("block", row["block"]), line("cell", row["cell"]),
        line("order", row["interval_order"]), line("correct interval", row["correct_interval"])])


def presentation_text(row):
    ended = row["presentation"] is not None
    return "".join([
        line("interval", row["interval"]), line("attempt", row["attempt"]), line("condition", row["condition"]),
        line("begun", row["begun_utc"]), line("onset", row["onset_utc"] if ended else ""),
        line("verdict", row["verdict"] if ended else ""), line("presses", row["n_presses"] if ended else 0),
        line("time", shortest(row["exploration_time_s"] or 0)), line("peak force", shortest(row["peak_force_n"] or 0)),
        line("max depth", shortest(row["max_depth_m"] or 0)), line("clamped", shortest(row["clamped_fraction"] or 0)),
        line("loop rate", shortest(row["loop_rate_hz"])), line("loop p999", shortest(row["loop_p999_ms"])),
        line("missed", -1 if row["missed_cycles"] is None else row["missed_cycles"]),
        "" if row["force_error_bound_n"] is None else
        line("force bound", shortest(row["force_error_bound_n"])) +
        line("within tolerance", row["cycles_within_tolerance"]) + line("at cap", row["cycles_at_cap"]),
        line("samples", row["samples"] or 0), line("trace", row["sha256"] or "")])


def answer_text(answer, session, trial, felt):
    return "".join(["answer\n", session_text(session), trial_text(trial), *map(presentation_text, felt),
                    line("response", answer["response"]), line("correct", answer["correct"]),
                    line("response time", shortest(answer["response_time_s"])),
                    line("question onset", answer["onset_utc"]), line("committed", answer["committed_utc"])])


def event_text(event):
    return "".join(["event\n", line("session", -1 if event["session"] is None else event["session"]),
                    line("trial", -1 if event["trial"] is None else event["trial"]), line("kind", event["kind"]),
                    line("text", event["text"]), line("utc", event["utc"])])


def genesis(database):
    study = database.execute("SELECT * FROM study").fetchone()
    text = "palpate study 1\n" + line("uuid", study["uuid"]) + line("created", study["created_utc"])
    text += line("protocol", study["protocol_sha256"]) + line("version", study["software_version"])
    for file in database.execute("SELECT * FROM study_file ORDER BY position"):
        text += line(file["name"], file["sha256"])
    return sha256(text)


def entries(database):
    """(session, text) of each entry of the chain, in order."""
    sessions = {row["id"]: row for row in database.execute("SELECT * FROM session")}
    trials = {(row["session"], row["number"], row["draw"]): row for row in database.execute("SELECT * FROM trial")}
    felt = {}
    for row in database.execute("SELECT * FROM presentation LEFT JOIN presentation_end ON presentation = id "
                                "LEFT JOIN trace USING (presentation) LEFT JOIN presentation_solve USING (presentation) "
                                "ORDER BY id"):
        felt.setdefault((row["session"], row["trial"], row["draw"]), []).append(row)
    found = {}
    for row in database.execute("SELECT * FROM answer"):
        at = (row["session"], row["trial"], row["draw"])
        found[row["entry"]] = (row["session"],
                               answer_text(row, sessions[row["session"]], trials[at], felt.get(at, [])))
    for row in database.execute("SELECT * FROM event"):
        found[row["entry"]] = (row["session"], event_text(row))
    return [found[entry] for entry in sorted(found)]


def without_clocks(text):
    kept = []
    for row in text.splitlines():
        name, _, value = row.partition("=")
        if name == "text":  # of an event, a text of lines itself
            value = without_clocks(value.replace("\\n", "\n"))
        if name not in CLOCKS:
            kept.append(f"{name}={value}")
    return "\n".join(kept)


def sittings(file):
    """Of each sitting: its examinee, its entries in the chain, and the head of the chain that they make without clocks,
    machine and version. The file's own chain must be the one computed here."""
    database = sqlite3.connect(f"file:{file}?mode=ro", uri=True)
    database.row_factory = sqlite3.Row
    head, heads, counts = genesis(database), {}, {}
    stored = [row["hash"] for row in database.execute("SELECT hash FROM ledger ORDER BY entry")]
    for hashed, (session, text) in zip(stored, entries(database), strict=True):
        head = sha256(f"{head}\n{text}")
        if head != hashed:
            raise SystemExit(f"{file}: an entry of session {session} has another hash than its text:\n{text}")
        heads[session] = sha256(f"{heads.get(session, '')}\n{without_clocks(text)}")
        counts[session] = counts.get(session, 0) + 1
    names = {row["id"]: row["examinee"] for row in database.execute("SELECT * FROM session")}
    return [{"examinee": names.get(session, ""), "entries": counts[session], "head": heads[session]}
            for session in heads]  # in the order of their first entries; "" is the study itself
