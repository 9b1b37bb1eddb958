using System.Globalization;
using System.Text.Json;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary>The status of a cell.</summary>
internal sealed class CellStatusAnswer(CellSettings settings, CellStatus status) : DocumentAnswer
{
    private const int MostListed = 20;

    public override string Schema => "errormatch/cell-status/1";

    public override Failure? Failure =>
        status.IsHealthy ? null : new(ExitCode.Outside, [.. Problems().Select(p => new Refusal(p.Code, p.Message))]);

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("cell", settings.Name);
        json.WriteBoolean("healthy", status.IsHealthy);
        json.WriteBoolean("running", status.IsRunning);
        if (status.IsRunning)
        {
            json.WriteNumber("processId", status.Heartbeat!.ProcessId);
            json.WriteString("since", CorrectionJson.Time(status.Heartbeat.Since));
        }

        json.WriteStartArray("slots");
        foreach (var slot in status.Slots)
        {
            Write(json, slot);
        }

        json.WriteEndArray();
        Write(json, "inWork", status.InWork);
        Write(json, "proposed", status.Proposed);
        Write(json, "failed", status.Failed);
        json.WriteStartArray("backlog");
        foreach (var backlog in status.Backlog)
        {
            Write(json, backlog);
        }

        json.WriteEndArray();
        json.WriteStartObject("counts");
        foreach (var state in Enum.GetValues<CorrectionState>())
        {
            json.WriteNumber(CorrectionJson.Word(state), status.CountOf(state));
        }

        json.WriteEndObject();
        json.WriteStartArray("problems");
        foreach (var (code, message) in Problems())
        {
            json.WriteStartObject();
            json.WriteString("code", code);
            json.WriteString("message", message);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    public override void WriteText(Page page)
    {
        page.Heading(status.IsRunning
            ? $"{settings.Name} has been running since {Time(status.Heartbeat!.Since)}, process {Number(status.Heartbeat.ProcessId)}"
            : $"{settings.Name} is not running");
        page.Line();
        page.Table(["machine", "slot", "program", "holds", "state", "since", "waiting", "next"], status.Slots.Select(Row));
        foreach (var held in status.Slots.Select(s => s.Held).OfType<Correction>().Where(c => c.Offset is not null))
        {
            page.Line(PrintedText.OneLine($"{held.Machine}/{held.Slot}: {held.Offset!.Sentence}"));
        }

        foreach (var report in status.Slots.Select(s => s.Report).OfType<MachineReport>().DistinctBy(r => r.Machine))
        {
            page.Line(PrintedText.OneLine(
                $"{report.Machine}: {MachineStateJson.Text(report.State)}, since {Time(report.State.Since!.Value)}"
                + (report.Reason is { } why ? $": {why}" : "")));
        }

        foreach (var delivery in status.Slots.Select(s => s.Delivery).OfType<WaitingDelivery>())
        {
            page.Line(PrintedText.OneLine($"{delivery.Machine}/{delivery.Slot}: correction {Number(delivery.Correction)} waits since "
                + $"{Time(delivery.Since)}: {delivery.Statement}"));
        }

        List(page, "Waiting for a person", status.Proposed, status.CountOf(CorrectionState.Proposed));
        List(page, "Failed", status.Failed, status.CountOf(CorrectionState.Failed));
        if (status.InWork.Count > 0)
        {
            page.Line();
            page.Line($"{Number(status.InWork.Count)} arrived and not computed yet.");
        }

        foreach (var backlog in status.Backlog.Where(b => b.Count > 0))
        {
            page.Line(PrintedText.OneLine($"{backlog.Gauge}: waiting since {Time(backlog.Since!.Value)}: files "
                + $"{(backlog.AreMore ? "at least " : "")}{Number(backlog.Files)}, measurements not computed {Number(backlog.Pieces)}"));
        }

        var next = WhatNext().ToArray();
        page.Line();
        page.Heading(next.Length == 0 ? "Nothing to do." : "What to do next");
        foreach (var line in next)
        {
            page.Line("- " + PrintedText.OneLine(line));
        }
    }

    private static void Write(Utf8JsonWriter json, GaugeBacklog backlog)
    {
        json.WriteStartObject();
        json.WriteString("gauge", backlog.Gauge);
        json.WriteNumber("files", backlog.Files);
        json.WriteNumber("pieces", backlog.Pieces);
        json.WriteString("oldestSince", backlog.Since is { } since ? CorrectionJson.Time(since) : null);
        json.WriteBoolean("growing", backlog.IsGrowing);
        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, SlotStatus slot)
    {
        json.WriteStartObject();
        json.WriteString("machine", slot.Machine.Name);
        json.WriteString("slot", slot.Slot.Name);
        json.WriteString("program", slot.Slot.Program);
        json.WriteString("programSha256", slot.Holding.ProgramSha256);
        json.WritePropertyName("held");
        if (slot.Held is { } held)
        {
            CorrectionJson.Write(json, held);
        }
        else
        {
            json.WriteNullValue();
        }

        json.WriteNumber("waiting", slot.Waiting);
        Write(json, "next", slot.Next);
        json.WriteStartArray("heldUp");
        foreach (var heldUp in slot.HeldUp)
        {
            json.WriteStartObject();
            json.WriteNumber("correction", heldUp.Correction.Id);
            json.WriteStartArray("behind");
            foreach (var before in heldUp.Behind)
            {
                json.WriteNumberValue(before.Id);
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        json.WriteEndArray();
        if (slot.Report is { } report)
        {
            MachineStateJson.Write(json, report.State with { Why = report.Reason });
        }

        if (slot.Delivery is { } delivery)
        {
            json.WriteStartObject("waitsForMachine");
            json.WriteNumber("correction", delivery.Correction);
            json.WriteString("since", CorrectionJson.Time(delivery.Since));
            json.WriteString("reason", delivery.Statement.Sentence);
            CorrectionJson.Write(json, "reasonStatement", delivery.Statement);
            json.WriteEndObject();
        }

        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, string name, IReadOnlyList<Correction> corrections)
    {
        json.WriteStartArray(name);
        foreach (var correction in corrections)
        {
            CorrectionJson.Write(json, correction);
        }

        json.WriteEndArray();
    }

    private IReadOnlyList<string> Row(SlotStatus slot) =>
    [
        slot.Machine.Name,
        slot.Slot.Name,
        slot.Slot.Program,
        slot.Held is { } held ? Label(held) : "",
        slot.Held is { } h ? CorrectionJson.Word(h.State) : "free",
        slot.Held is { } s ? Time(s.ChangedAt) : "",
        Number(slot.Waiting),
        slot.Next is [var first, ..] ? Label(first) : "",
    ];

    private static void List(Page page, string heading, IReadOnlyList<Correction> corrections, long count)
    {
        if (corrections.Count == 0)
        {
            return;
        }

        page.Line();
        page.Heading(count > MostListed ? $"{heading}: {Number(count)}, the first {Number(MostListed)}" : heading);
        page.Table(
            ["id", "file", "job", "serial", "largest mm", "sum mm", "since", "why"],
            corrections.Take(MostListed).Select(c => (IReadOnlyList<string>)
            [
                Number(c.Id), c.FileName, c.Job ?? "", c.Serial ?? "", c.LargestMm is { } mm ? Show.Mm(mm) : "",
                c.SumMm is { } sum ? Show.Mm(sum) : "", Time(c.ChangedAt), c.Code ?? "",
            ]));
    }

    private IEnumerable<(string Code, string Message)> Problems()
    {
        if (!status.IsRunning)
        {
            yield return ("cell-not-running", status.Heartbeat is { } last
                ? $"The cell does not run: its last sign of life was at {Time(last.At)}. Nothing is lost: start it again."
                : "The cell does not run. Start it: errormatch cell run.");
        }

        foreach (var trouble in status.IsRunning ? status.Heartbeat!.Troubles : [])
        {
            yield return (trouble.Code, $"{trouble.Where}, since {Time(trouble.Since)}: {trouble.Message}");
        }

        foreach (var tampered in status.Tampered.Take(MostListed))
        {
            yield return (CellCodes.Of(StoreError.Tampered), tampered.Sentence);
        }

        foreach (var missing in status.MissingArchives.Take(MostListed))
        {
            yield return (CellCodes.Of(StoreError.Archived), missing);
        }

        foreach (var failed in status.Failed.Take(MostListed))
        {
            yield return (failed.Code ?? "failed", $"Correction {Number(failed.Id)} ({failed.FileName}) failed: {failed.Reason}");
        }

        if (status.Failed.Count > MostListed)
        {
            yield return ("failed", $"{Number(status.Failed.Count - MostListed)} more corrections failed.");
        }
    }

    private IEnumerable<string> WhatNext()
    {
        if (!status.IsRunning)
        {
            yield return $"Start the cell: errormatch cell run {settings.File}";
        }

        foreach (var tampered in status.Tampered.Take(MostListed).Select(t => t.Sentence)
            .Concat(Troubles(isTampered: true).Select(t => t.Message))
            .Distinct(StringComparer.Ordinal))
        {
            yield return tampered;
        }

        foreach (var trouble in Troubles(isTampered: false))
        {
            yield return trouble.Code is CellCodes.WaitsTooLong or CellCodes.BacklogGrows or CellCodes.PieceWaits
                ? $"{trouble.Where}: {trouble.Message}"
                : trouble.Code == CellCodes.ChangedAtMachine
                ? $"{trouble.Where}: look at it at the machine. Then release the correction with --reason "
                    + $"(errormatch cell release {settings.File} NUMBER), or put its program back."
                : $"{trouble.Where}: put right what it says ({trouble.Code}); the cell goes on by itself.";
        }

        foreach (var failed in status.Failed.Take(MostListed))
        {
            yield return failed.ProgramSha256 is null
                ? $"{Number(failed.Id)}: put right what it says, reject it (errormatch cell reject {settings.File} {Number(failed.Id)} "
                    + $"--reason ...), and measure again."
                : $"{Number(failed.Id)}: put right what it says, then errormatch cell approve {settings.File} {Number(failed.Id)}, or "
                    + $"reject it. Those behind it in its slot's line wait.";
        }

        foreach (var more in More("failed", status.Failed.Count))
        {
            yield return more;
        }

        var held = status.Slots.SelectMany(s => s.HeldUp).ToArray();
        foreach (var heldUp in held.Take(MostListed))
        {
            yield return $"{Number(heldUp.Correction.Id)} is approved and waits in line behind {Numbers(heldUp.Behind)}: decide about "
                + $"what stands before it first.";
        }

        foreach (var more in More("approved", held.Length))
        {
            yield return more;
        }

        foreach (var proposed in status.Proposed.Take(MostListed))
        {
            yield return $"{Number(proposed.Id)}: read its report (errormatch cell show {settings.File} {Number(proposed.Id)} --out DIR), "
                + $"then approve or reject it.";
        }

        foreach (var more in More("proposed", status.Proposed.Count))
        {
            yield return more;
        }

        foreach (var slot in status.Slots.Where(
            s => s.Held is { WaitsForRelease: true } && s.Slot.ReadyFile is null))
        {
            yield return $"{slot.Machine.Name}/{slot.Slot.Name}: when the piece of {Label(slot.Held!)} is cut, errormatch cell release "
                + $"{settings.File} {Number(slot.Held!.Id)}";
        }
    }

    // What is left out is counted, and the command lists it.
    private IEnumerable<string> More(string state, int count) => count <= MostListed ? []
        : [
            $"{Number(count - MostListed)} more are {state}: errormatch cell history {settings.File} --state {state} "
                + $"--most {Number(count)}"];

    // A change to the store from outside the cell does not go away on its own; its message says what to do.
    private IEnumerable<CellTrouble> Troubles(bool isTampered) =>
        (status.IsRunning ? status.Heartbeat!.Troubles : []).Where(t => t.Code == CellCodes.Of(StoreError.Tampered) == isTampered);

    private static string Label(Correction correction) =>
        correction.Serial is { } serial ? $"{Number(correction.Id)} {serial}" : Number(correction.Id);

    private static string Numbers(IReadOnlyList<Correction> corrections) =>
        string.Join(", ", corrections.Take(MostListed).Select(c => Number(c.Id)))
        + (corrections.Count > MostListed ? $" and {Number(corrections.Count - MostListed)} more" : "");

    private static string Number(long value) => value.ToString(CultureInfo.InvariantCulture);

    private static string Time(DateTimeOffset time) => time.ToString("yyyy-MM-dd HH:mm:ss'Z'", CultureInfo.InvariantCulture);
}
