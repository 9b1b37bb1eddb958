using System.Data.Common;
using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>Reads corrections: by state, in line for a slot, and the latest of a job.</summary>
/// <remarks>Every member throws a <see cref="StoreException"/> if the store cannot be read.</remarks>
public sealed class CorrectionQueries
{
    private readonly CellDatabase _database;

    internal CorrectionQueries(CellDatabase database) => _database = database;

    /// <summary>The corrections in any of the given states, in order of arrival.</summary>
    public IReadOnlyList<Correction> InState(params CorrectionState[] states) => states is []
        ? []
        : Read(CorrectionRow.Select + $" WHERE {CorrectionRow.IsIn("state", states)} ORDER BY id", CorrectionRow.Read);

    /// <summary>The steps of a correction, in order.</summary>
    public IReadOnlyList<CorrectionStep> StepsOf(long id) =>
        Read(
            "SELECT correction, from_state, to_state, at, who, basis FROM step WHERE correction = @id ORDER BY step.id",
            CorrectionRow.ReadStep,
            [("id", id)]);

    /// <summary>The people who took steps of corrections, each once, in the order of their first step.</summary>
    /// <param name="ids">Numbers of the corrections.</param>
    /// <returns>Their names by number; a correction that only the cell took further is absent.</returns>
    public IReadOnlyDictionary<long, IReadOnlyList<string>> PeopleOf(IReadOnlyCollection<long> ids)
    {
        ArgumentNullException.ThrowIfNull(ids);
        return ids.Count == 0 ? new Dictionary<long, IReadOnlyList<string>>() : Read(
            $"SELECT correction, who, min(id) FROM step WHERE who <> @Cell AND correction IN ({string.Join(',', ids)}) "
                + "GROUP BY correction, who ORDER BY min(id)",
            r => (Id: r.GetInt64(0), Who: r.GetString(1)),
            [("Cell", AuditEntry.ByCell)])
            .GroupBy(s => s.Id, s => s.Who)
            .ToDictionary(g => g.Key, g => (IReadOnlyList<string>)[.. g]);
    }

    // A failed one is in line only with a program.
    private static readonly CorrectionState[] InLine = [.. CorrectionSteps.Where(s => s.IsInLine).Except([CorrectionState.Failed])];

    /// <summary>The corrections in line for a slot, in order of arrival: from recognized to approved, and those that failed there. A
    /// correction that failed without a program has nothing to send and is excluded. One that recalculates an earlier
    /// one has that one's place from the start.</summary>
    /// <param name="machine">The machine.</param>
    /// <param name="slot">Its slot.</param>
    public IReadOnlyList<Correction> Line(string machine, string slot) => Read(
        CorrectionRow.Select
            + " WHERE machine = @machine AND slot = @slot AND ("
            + CorrectionRow.IsIn("state", InLine)
            + " OR (state = @Failed AND program_sha256 IS NOT NULL)) ORDER BY COALESCE(measured_as, id), id",
        CorrectionRow.Read,
        [("machine", machine), ("slot", slot), ("Failed", CorrectionRow.Word(CorrectionState.Failed))]);

    /// <summary>The first correction of <see cref="Line"/>, without reading the others; null if the line is empty.</summary>
    internal Correction? FirstInLine(string machine, string slot)
    {
        // The least number of each state is the first of an index, and so is the least place of those that recalculate. The one
        // of both that comes first is the first in line: one that recalculates comes before its own number.
        string[] inLine = [.. InLine.Select(s => $"state = '{CorrectionRow.Word(s)}'"),
            $"state = '{CorrectionRow.Word(CorrectionState.Failed)}' AND program_sha256 IS NOT NULL"];
        const string Here = "machine = @machine AND slot = @slot AND ";
        var least = string.Join(
            " UNION ALL ",
            inLine.SelectMany(s => new[]
            {
                $"SELECT min(id) AS turn FROM correction WHERE {Here}{s}",
                $"SELECT min(measured_as) AS turn FROM correction WHERE {Here}{s} AND measured_as IS NOT NULL",
            }));
        var earliest = Read(
            $"SELECT min(turn) FROM ({least}) AS least",
            r => r.IsDBNull(0) ? (long?)null : r.GetInt64(0),
            [("machine", machine), ("slot", slot)]);
        if (earliest is not [{ } turn])
        {
            return null;
        }

        var any = $"{Here}({string.Join(" OR ", inLine.Select(s => $"({s})"))})";
        return First(
                CorrectionRow.Select + $" WHERE id = @turn AND measured_as IS NULL AND {any}",
                CorrectionRow.Read,
                [("machine", machine), ("slot", slot), ("turn", turn)])
            ?? First(
                CorrectionRow.Select + $" WHERE measured_as = @turn AND {any} ORDER BY id LIMIT 1",
                CorrectionRow.Read,
                [("machine", machine), ("slot", slot), ("turn", turn)])

            // It took a step between the two looks.
            ?? (Line(machine, slot) is [var first, ..] ? first : null);
    }

    /// <summary>The first corrections in a state, in order of arrival, for given gauges or jobs, since several cells may share a
    /// store.</summary>
    /// <param name="state">The state.</param>
    /// <param name="most">Maximum number of corrections.</param>
    /// <param name="gauges">The gauges; null for all.</param>
    /// <param name="jobs">The cell's jobs; null for all.</param>
    public IReadOnlyList<Correction> First(
        CorrectionState state, int most, IReadOnlyList<string>? gauges = null, IReadOnlyList<string>? jobs = null)
    {
        List<(string, SqlArgument)> parameters = [("State", CorrectionRow.Word(state)), ("most", most)];
        var where = " WHERE state = @State" + IsOneOf("gauge", gauges, parameters) + IsOneOf("job", jobs, parameters);
        return Read(CorrectionRow.Select + where + " ORDER BY id LIMIT @most", CorrectionRow.Read, parameters);
    }

    /// <summary>The latest corrections of some jobs that have a report, last arrival first. A series of pieces is displayed from
    /// them.</summary>
    /// <param name="jobs">The cell's jobs.</param>
    /// <param name="most">Maximum number of corrections.</param>
    public IReadOnlyList<Correction> Reported(IReadOnlyList<string> jobs, int most)
    {
        List<(string, SqlArgument)> parameters = [("most", most)];
        var where = " WHERE report_sha256 IS NOT NULL" + IsOneOf("job", jobs, parameters);
        return Read(CorrectionRow.Select + where + " ORDER BY id DESC LIMIT @most", CorrectionRow.Read, parameters);
    }

    /// <summary>The number of corrections of some jobs that have a report.</summary>
    /// <param name="jobs">The cell's jobs.</param>
    public long CountReported(IReadOnlyList<string> jobs)
    {
        List<(string, SqlArgument)> parameters = [];
        var where = " WHERE report_sha256 IS NOT NULL" + IsOneOf("job", jobs, parameters);
        return Read("SELECT count(*) FROM correction" + where, r => r.GetInt64(0), parameters)[0];
    }

    /// <summary>The number of corrections in each state; states without any are omitted.</summary>
    public IReadOnlyDictionary<CorrectionState, long> Counts() =>
        Read(
            "SELECT state, count(*) FROM correction GROUP BY state",
            r => (State: Enum.Parse<CorrectionState>(r.GetString(0), ignoreCase: true), Count: r.GetInt64(1)))
            .ToDictionary(c => c.State, c => c.Count);

    /// <summary>The correction of a job whose program was last verified at its machine and not reverted; null if there is none.</summary>
    /// <param name="job">The cell's job.</param>
    /// <param name="serial">The serial number of the piece; null for any.</param>
    public Correction? LastSent(string job, string? serial)
    {
        var columns = string.Join(", ", CorrectionRow.Columns.Split(", ").Select(c => "correction." + c));
        var verified = CorrectionRow.IsIn("step.to_state", CorrectionState.Verified);
        var sent = "correction.job = @job AND "
            + CorrectionRow.IsIn("correction.state", CorrectionSteps.Where(s => s.IsSent));

        // Any piece: from the last step on, until one is of the job. A serial number has few corrections.
        var from = serial is null
            ? $"step CROSS JOIN correction WHERE {verified} AND correction.id = step.correction AND {sent}"
            : $"correction JOIN step ON step.correction = correction.id AND {verified} WHERE {sent} AND correction.serial = @serial";
        var found = Read(
            $"SELECT {columns} FROM {from} ORDER BY step.id DESC LIMIT 1", CorrectionRow.Read, [("job", job), ("serial", serial)]);
        return found is [var last] ? last : null;
    }

    /// <summary>The latest measurement of a job's part that was recognized or recorded; null if there is none.</summary>
    /// <remarks>If a serial number or a work order is given, the part matches at least one and contradicts neither. A value that the part
    /// lacks may be anything.</remarks>
    /// <param name="job">The cell's job.</param>
    /// <param name="serial">Serial number of the piece; null if unknown.</param>
    /// <param name="workOrder">The work order; null if unknown.</param>
    public Correction? LastPart(string job, string? serial, string? workOrder)
    {
        var known = string.Join(
            " OR ",
            new[] { serial is null ? null : "serial = @serial", workOrder is null ? null : "work_order = @workOrder" }.OfType<string>());
        var found = Read(
            CorrectionRow.Select
                + $" WHERE job = @job AND piece = '{PieceWords.Part}' AND "
                    + $"{CorrectionRow.IsIn("state", CorrectionState.Recognized, CorrectionState.Recorded)}"
            + (serial is null ? "" : " AND (serial = @serial OR serial IS NULL)")
                + (workOrder is null ? "" : " AND (work_order = @workOrder OR work_order IS NULL)")
            + (known.Length == 0 ? "" : $" AND ({known})")
            + " ORDER BY COALESCE(measured_as, id) DESC, id DESC LIMIT 1",
            CorrectionRow.Read,
            [("job", job), ("serial", serial), ("workOrder", workOrder)]);
        return found is [var last] ? last : null;
    }

    /// <summary>The corrections with a given measurement content, in order of arrival.</summary>
    public IReadOnlyList<Correction> OfMeasurement(string sha256) =>
        Read(CorrectionRow.Select + " WHERE measurement_sha256 = @sha256 ORDER BY id", CorrectionRow.Read, [("sha256", sha256)]);

    /// <summary>A job's corrections with a given compensated program, in order of arrival.</summary>
    /// <param name="job">The cell's job.</param>
    /// <param name="sha256">The program.</param>
    public IReadOnlyList<Correction> OfProgram(string job, string sha256) =>
        Read(
            CorrectionRow.Select + " WHERE program_sha256 = @sha256 AND job = @job ORDER BY id",
            CorrectionRow.Read,
            [("sha256", sha256), ("job", job)]);

    /// <summary>The corrections that a worker takes on, grouped by what they wait for.</summary>
    internal IReadOnlyList<WaitingCorrections> Waiting() => Read(
        "SELECT state, gauge, job, machine, slot, count(*), min(id) FROM correction WHERE "
        + CorrectionRow.IsIn("state", CorrectionSteps.Where(s => s.TakenBy is not null))
        + " GROUP BY state, gauge, job, machine, slot",
        r => new WaitingCorrections(
            Enum.Parse<CorrectionState>(r.GetString(0), ignoreCase: true),
            r.GetString(1),
            r.TextOrNull(2),
            r.TextOrNull(3),
            r.TextOrNull(4),
            r.GetInt64(5),
            r.GetInt64(6)));

    // One parameter each: the two engines take a list as a single parameter in different ways.
    private static string IsOneOf(string column, IReadOnlyList<string>? names, List<(string, SqlArgument)> parameters)
    {
        if (names is null)
        {
            return "";
        }

        var marks = names.Select((_, i) => string.Create(CultureInfo.InvariantCulture, $"@{column}{i}")).ToArray();
        for (var i = 0; i < marks.Length; i++)
        {
            parameters.Add((marks[i], names[i]));
        }

        return marks.Length == 0 ? " AND 1 = 0" : $" AND {column} IN ({string.Join(", ", marks)})";
    }

    private IReadOnlyList<T> Read<T>(string sql, Func<DbDataReader, T> row, SqlArguments? parameters = null) =>
        _database.Read(connection => Rows.Query(connection, sql, row, parameters));

    private Correction? First(string sql, Func<DbDataReader, Correction> row, SqlArguments? parameters) =>
        _database.Read(connection => Rows.First(connection, sql, row, parameters));
}

/// <summary>Corrections that have not ended and wait for the same thing.</summary>
/// <param name="State">Their state.</param>
/// <param name="Gauge">The gauge that they came from.</param>
/// <param name="Job">Their job; null before they are recognized.</param>
/// <param name="Machine">Their machine; null before they are recognized.</param>
/// <param name="Slot">Its slot; null before they are recognized.</param>
/// <param name="Count">How many.</param>
/// <param name="First">Number of the first.</param>
internal sealed record WaitingCorrections(
    CorrectionState State, string Gauge, string? Job, string? Machine, string? Slot, long Count, long First);
