using System.Globalization;
using System.Text.Json;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Json;

namespace ErrorMatching.Console;

/// <summary>What a cell would find if it started now.</summary>
internal sealed class CellCheckAnswer(CellSettings settings, CellCheck check) : DocumentAnswer
{
    public override string Schema => "errormatch/cell-check/1";

    public override Failure? Failure => check.Wrong.Concat(check.Away).SelectMany(p => p.Errors).ToArray() is { Length: > 0 } errors
        ? new(check.Wrong.Any() ? ExitCode.WrongInput : ExitCode.Outside, errors)
        : null;

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("file", settings.File);
        json.WriteString("cell", settings.Name);
        Array(json, "gauges", check.Gauges, g => WriteGauge(json, g));
        Array(json, "machines", check.Machines, m => WriteMachine(json, m));
        json.WriteStartObject("store");
        json.WriteString("kind", settings.Store is SqliteSettings ? "sqlite" : "postgresql");
        json.WriteString("place", StorePlace(PathText.Of));
        json.WriteBoolean("exists", check.Store.IsThere);
        json.WriteNumber("form", check.Store.Form);
        json.WriteNumber("latestForm", check.Store.Latest);
        json.WriteBoolean("ok", check.Store.Problem is null);
        json.WriteEndObject();
        Array(json, "jobs", check.Jobs, j => WriteJob(json, j));
        if (check.Broker is { } broker)
        {
            json.WriteStartObject("broker");
            json.WriteString("address", broker.Broker.Address);
            json.WriteString("topic", broker.Broker.Topic);
            json.WriteBoolean("ok", broker.Problem is null);
            json.WriteEndObject();
        }

        json.WriteStartArray("notTried");
        foreach (var untried in check.Untried)
        {
            json.WriteStringValue(untried);
        }

        json.WriteEndArray();
        Array(json, "warnings", settings.Warnings, w =>
        {
            json.WriteString("code", w.Code);
            json.WriteString("message", w.Message);
            json.WriteNumber("line", w.Place.Line ?? 1);
            json.WriteNumber("column", w.Place.Column ?? 1);
            json.WriteString("path", w.Place.Path);
        });
        if (Failure is { } failure)
        {
            OutcomeWriter.WriteErrors(json, failure);
        }
    }

    public override void WriteText(Page page)
    {
        page.Heading($"{settings.File} is a valid configuration: {settings.Name}");
        page.Line();
        page.Table(
            ["gauge", "where", "waiting", ""],
            check.Gauges.Select(
                g => (IReadOnlyList<string>)[
                    g.Gauge.Name, Where(g.Gauge), g.Problem is null ? Number(g.Files.Count + g.More) : "", State(g.Problem)]));
        WriteFiles(page);
        page.Line();
        page.Table(
            ["machine", "transport", "slots", ""],
            check.Machines.Select(
                m => (IReadOnlyList<string>)[
                    m.Machine.Name,
                    Transport(m.Machine.Transport, Shown),
                    string.Join(", ", m.Machine.Slots.Select(s => Slot(m, s))),
                    State(m.Problem)]));
        foreach (var machine in check.Machines.Where(m => m.State is not null))
        {
            page.Line(PrintedText.OneLine($"{machine.Machine.Name}, {Source(machine.Machine.State!, Shown)}: "
                + $"{MachineStateJson.Text(machine.State!)}{(machine.State!.Why is { } why ? $": {why}" : "")}"));
        }

        page.Line();
        page.Table(["job", "file", "starts from", "motions", ""], check.Jobs.Select(j => (IReadOnlyList<string>)
        [
            j.Job.Name, Shown(j.Job.File), j.Program is null ? "a tool path that it computes" : Shown(j.Program),
            j.Motions is { } motions ? Number(motions) : "", State(j.Problem),
        ]));
        page.Line();
        if (check.Broker is { } broker)
        {
            page.Line($"Broker: {broker.Broker.Address}, topic {broker.Broker.Topic}, {State(broker.Problem)}.");
        }

        page.Line($"Store: {StorePlace(Shown)}, {StoreState}.");
        foreach (var untried in check.Untried)
        {
            page.Line($"Not tried: {untried}");
        }

        foreach (var warning in settings.Warnings)
        {
            page.Warning(string.Create(
                CultureInfo.InvariantCulture, $"line {warning.Place.Line}, {warning.Place.Path}: {warning.Message}"));
        }
    }

    private string StorePlace(Func<string, string> shown) => settings.Store switch
    {
        SqliteSettings sqlite => shown(sqlite.File),
        PostgresSettings p => string.Create(CultureInfo.InvariantCulture, $"{p.Database} on {p.Host}:{p.Port}"),
        _ => "",
    };

    private string StoreState => check.Store switch
    {
        { Problem: not null } => State(check.Store.Problem),
        { IsThere: false } => "not there yet: errormatch user add makes it, with its folder and its first user",
        { Form: var form, Latest: var latest } =>
            form < latest
                ? string.Create(CultureInfo.InvariantCulture, $"form {form}, which is taken to form {latest} when the cell starts")
                : string.Create(CultureInfo.InvariantCulture, $"form {form}"),
    };

    private static void Array<T>(Utf8JsonWriter json, string name, IEnumerable<T> items, Action<T> write)
    {
        json.WriteStartArray(name);
        foreach (var item in items)
        {
            json.WriteStartObject();
            write(item);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteGauge(Utf8JsonWriter json, CheckedGauge gauge)
    {
        json.WriteString("name", gauge.Gauge.Name);
        json.WriteString("incoming", gauge.Gauge.Incoming is { } folder ? PathText.Of(folder) : null);
        json.WriteString("machine", gauge.Gauge.Machine);
        json.WriteBoolean("ok", gauge.Problem is null);
        json.WriteNumber("waiting", gauge.Files.Count + gauge.More);
        Array(json, "files", gauge.Files, file =>
        {
            json.WriteString("name", file.Name);
            if (file.Bytes is { } bytes)
            {
                json.WriteNumber("bytes", bytes);
            }

            if (file.Found is { } found)
            {
                json.WriteString("job", found.Job?.Name);
                json.WriteString("piece", found.Piece);
                json.WriteString("serial", found.Serial);
                json.WriteString("workOrder", found.WorkOrder);
                json.WriteString("code", found.Code);
                json.WriteString("reason", found.Reason?.Sentence);
                CorrectionJson.Write(json, "reasonStatement", found.Reason);
            }
        });
        Array(json, "left", gauge.Left, left =>
        {
            json.WriteString("name", left.Name);
            json.WriteString("reason", left.Reason);
        });
    }

    private static void WriteMachine(Utf8JsonWriter json, CheckedMachine machine)
    {
        json.WriteString("name", machine.Machine.Name);
        json.WriteString("transport", Transport(machine.Machine.Transport, PathText.Of));
        json.WriteBoolean("ok", machine.Problem is null);
        json.WriteBoolean("needsPassword", machine.NeedsPassword);
        if (machine.State is { } state)
        {
            MachineStateJson.Write(json, state);
        }

        Array(json, "slots", machine.Machine.Slots, slot =>
        {
            json.WriteString("name", slot.Name);
            json.WriteString("program", slot.Program);
            if (machine.Names is { } names)
            {
                json.WriteBoolean("isThere", IsThere(names, slot));
            }
        });
    }

    private static void WriteJob(Utf8JsonWriter json, CheckedJob job)
    {
        json.WriteString("name", job.Job.Name);
        json.WriteString("file", PathText.Of(job.Job.File));
        json.WriteString("program", job.Program is { } program ? PathText.Of(program) : null);
        json.WriteBoolean("ok", job.Problem is null);
        if (job.Motions is { } motions)
        {
            json.WriteNumber("motions", motions);
        }
    }

    private void WriteFiles(Page page)
    {
        var files = check.Gauges.SelectMany(g => g.Files.Select(f => (g, f))).ToArray();
        if (files.Length > 0)
        {
            page.Line();
            page.Table(["file", "gauge", "job", "piece", "serial", "work order", ""], files.Select(f => (IReadOnlyList<string>)
            [
                f.f.Name, f.g.Gauge.Name, f.f.Found?.Job?.Name ?? "", f.f.Found?.Piece ?? "", f.f.Found?.Serial ?? "",
                f.f.Found?.WorkOrder ?? "", f.f.Found is null ? "at the machine" : f.f.Found.Code ?? "",
            ]));
        }

        foreach (var (file, found) in files.Where(f => f.f.Found?.Reason is not null).Select(f => (f.f.Name, f.f.Found!)))
        {
            page.Line($"{file}: {found.Reason}");
        }

        foreach (var left in check.Gauges.SelectMany(g => g.Left))
        {
            page.Line($"{left.Name} is left: {left.Reason}");
        }

        foreach (var gauge in check.Gauges.Where(g => g.More > 0))
        {
            page.Line($"And {Number(gauge.More)} more at {gauge.Gauge.Name}.");
        }
    }

    private static string State(CheckProblem? problem) => problem is null ? "ok" : problem.Errors[0].Code;

    private static string Slot(CheckedMachine machine, SlotSettings slot) =>
        $"{slot.Name} ({slot.Program}{(machine.Names is { } names && !IsThere(names, slot) ? ", none there yet" : "")})";

    private static bool IsThere(IReadOnlyList<string> names, SlotSettings slot) => names.Contains(slot.Program, StringComparer.Ordinal);

    private static string Where(GaugeSettings gauge) => gauge.Incoming is { } folder ? Shown(folder) : $"{gauge.Files} at {gauge.Machine}";

    private static string Transport(TransportSettings transport, Func<string, string> shown) =>
        transport.LocalFolder is { } folder ? shown(folder) : transport.Address;

    private static string Source(StateSettings state, Func<string, string> shown) =>
        state.LocalFile is { } file ? shown(file) : state.Address;

    // Paths below the current folder are shown relative to it.
    private static string Shown(string path) => PathText.Of(
        Path.GetRelativePath(Directory.GetCurrentDirectory(), path) is var relative && !relative.StartsWith("..", StringComparison.Ordinal)
            ? relative
            : path);

    private static string Number(int value) => value.ToString(CultureInfo.InvariantCulture);
}
