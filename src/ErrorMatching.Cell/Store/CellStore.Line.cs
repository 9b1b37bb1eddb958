using System.Globalization;
using Dapper;

namespace ErrorMatching.Cell;

public sealed partial class CellStore
{
    /// <summary>The corrections in line for a slot, in order of arrival: from recognized to approved, and those that failed there. A
    /// correction that failed without a program has nothing to send and is excluded. A resubmitted measurement keeps its earlier place from
    /// the moment it is resubmitted.</summary>
    /// <param name="machine">The machine.</param>
    /// <param name="slot">Its slot.</param>
    public IReadOnlyList<Correction> Line(string machine, string slot) => Read(
        CorrectionRow.Select
            + " WHERE machine = @machine AND slot = @slot AND ("
            + CorrectionRow.IsIn(
                "state",
                CorrectionState.Archived,
                CorrectionState.Recognized,
                CorrectionState.Computed,
                CorrectionState.Proposed,
                CorrectionState.Approved)
            + " OR (state = @Failed AND program_sha256 IS NOT NULL)) ORDER BY COALESCE(measured_as, id), id",
        CorrectionRow.Read,
        new { machine, slot, Failed = CorrectionRow.Word(CorrectionState.Failed) });

    /// <summary>The first corrections in a state, in order of arrival, for given gauges or jobs, since several cells may share a
    /// store.</summary>
    /// <param name="state">The state.</param>
    /// <param name="most">Maximum number of corrections.</param>
    /// <param name="gauges">The gauges; null for all.</param>
    /// <param name="jobs">The cell's jobs; null for all.</param>
    public IReadOnlyList<Correction> First(
        CorrectionState state, int most, IReadOnlyList<string>? gauges = null, IReadOnlyList<string>? jobs = null)
    {
        var parameters = new DynamicParameters(new { State = CorrectionRow.Word(state), most });
        var where = " WHERE state = @State" + IsOneOf("gauge", gauges, parameters) + IsOneOf("job", jobs, parameters);
        return Read(CorrectionRow.Select + where + " ORDER BY id LIMIT @most", CorrectionRow.Read, parameters);
    }

    /// <summary>The latest corrections of some jobs that have a report, last arrival first. A series of pieces is displayed from
    /// them.</summary>
    /// <param name="jobs">The cell's jobs.</param>
    /// <param name="most">Maximum number of corrections.</param>
    public IReadOnlyList<Correction> Reported(IReadOnlyList<string> jobs, int most)
    {
        var parameters = new DynamicParameters(new { most });
        var where = " WHERE report_sha256 IS NOT NULL" + IsOneOf("job", jobs, parameters);
        return Read(CorrectionRow.Select + where + " ORDER BY id DESC LIMIT @most", CorrectionRow.Read, parameters);
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
        var found = Read(
            $"SELECT {columns} FROM correction JOIN step ON step.correction = correction.id AND step.to_state = @Verified "
            + $"WHERE correction.job = @job AND "
                + $"{CorrectionRow.IsIn("correction.state", CorrectionState.Verified, CorrectionState.Released)}"
                + (serial is null ? "" : " AND correction.serial = @serial") + " ORDER BY step.id DESC LIMIT 1",
            CorrectionRow.Read,
            new { job, serial, Verified = CorrectionRow.Word(CorrectionState.Verified) });
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
                + $" WHERE job = @job AND piece = 'part' AND "
                    + $"{CorrectionRow.IsIn("state", CorrectionState.Recognized, CorrectionState.Recorded)}"
            + (serial is null ? "" : " AND (serial = @serial OR serial IS NULL)")
                + (workOrder is null ? "" : " AND (work_order = @workOrder OR work_order IS NULL)")
            + (known.Length == 0 ? "" : $" AND ({known})")
            + " ORDER BY COALESCE(measured_as, id) DESC, id DESC LIMIT 1",
            CorrectionRow.Read,
            new { job, serial, workOrder });
        return found is [var last] ? last : null;
    }

    /// <summary>The corrections with a given measurement content, in order of arrival.</summary>
    public IReadOnlyList<Correction> OfMeasurement(string sha256) =>
        Read(CorrectionRow.Select + " WHERE measurement_sha256 = @sha256 ORDER BY id", CorrectionRow.Read, new { sha256 });

    /// <summary>A job's corrections with a given compensated program, in order of arrival.</summary>
    /// <param name="job">The cell's job.</param>
    /// <param name="sha256">The program.</param>
    public IReadOnlyList<Correction> OfProgram(string job, string sha256) =>
        Read(CorrectionRow.Select + " WHERE program_sha256 = @sha256 AND job = @job ORDER BY id", CorrectionRow.Read, new { sha256, job });

    /// <summary>The corrections from archived to uploading, without failed ones, grouped by what they wait for.</summary>
    internal IReadOnlyList<WaitingCorrections> Waiting() => Read(
        "SELECT state, gauge, job, machine, slot, count(*), min(id) FROM correction WHERE "
        + CorrectionRow.IsIn(
            "state",
            CorrectionState.Archived,
            CorrectionState.Recognized,
            CorrectionState.Computed,
            CorrectionState.Proposed,
            CorrectionState.Approved,
            CorrectionState.Uploading)
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
    private static string IsOneOf(string column, IReadOnlyList<string>? names, DynamicParameters parameters)
    {
        if (names is null)
        {
            return "";
        }

        var marks = names.Select((_, i) => string.Create(CultureInfo.InvariantCulture, $"@{column}{i}")).ToArray();
        for (var i = 0; i < marks.Length; i++)
        {
            parameters.Add(marks[i], names[i]);
        }

        return marks.Length == 0 ? " AND 1 = 0" : $" AND {column} IN ({string.Join(", ", marks)})";
    }
}
