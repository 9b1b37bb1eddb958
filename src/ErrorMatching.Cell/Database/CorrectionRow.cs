using System.Data.Common;

namespace ErrorMatching.Cell;

/// <summary>Rows of corrections and their steps.</summary>
internal static class CorrectionRow
{
    private const string NamePrefix = "correction ";

    public const string Columns =
        "id, state, version, gauge, file_name, arrived_at, changed_at, measurement_sha256, measurement_bytes, job, piece, serial, "
            + "work_order, identity, "
        + "job_sha256, base_sha256, machine, slot, program, program_sha256, report_sha256, page_sha256, largest_mm, sum_mm, "
            + "previous_sha256, code, reason, trace, part_sha256, sums_sha256, job_work_order, measured_as, control_offset, undo_sha256";

    public const string Select = "SELECT " + Columns + " FROM correction";

    /// <summary>Rows with their codes, for <see cref="ReadKept"/>.</summary>
    public const string SelectKept = "SELECT " + Columns + ", row_code FROM correction";

    public const string Update =
        "UPDATE correction SET state = @State, version = @Version, changed_at = @ChangedAt, job = @Job, piece = @Piece, serial = "
            + "@Serial, work_order = @WorkOrder, identity = @Identity, "
        + "job_sha256 = @JobSha256, base_sha256 = @BaseSha256, machine = @Machine, slot = @Slot, program = @Program, program_sha256 = "
            + "@ProgramSha256, report_sha256 = @ReportSha256, "
        + "page_sha256 = @PageSha256, largest_mm = @LargestMm, sum_mm = @SumMm, previous_sha256 = @PreviousSha256, code = @Code, "
        + "reason = @Reason, trace = @Trace, part_sha256 = @PartSha256, sums_sha256 = @SumsSha256, job_work_order = @JobWorkOrder, "
        + "control_offset = @Offset, undo_sha256 = @UndoSha256, row_code = @RowCode "
        + "WHERE id = @Id AND version = @Version - 1 AND state = @From";

    public const string Insert =
        "INSERT INTO correction (state, version, arrival, gauge, file_name, arrived_at, changed_at, measurement_sha256, "
            + "measurement_bytes, code, reason, trace, job, piece, serial, work_order, machine, slot, program, measured_as) "
        + "VALUES (@State, 1, @Arrival, @Gauge, @FileName, @At, @At, @MeasurementSha256, @MeasurementBytes, @Code, @Reason, @Trace, @Job, "
            + "@Piece, @Serial, @WorkOrder, @Machine, @Slot, @Program, @MeasuredAs) RETURNING id";

    private static readonly string[] Words = [.. Enum.GetValues<CorrectionState>().Select(s => s.ToString().ToLowerInvariant())];

    /// <summary>The state's name in the store.</summary>
    public static string Word(CorrectionState state) => Words[(int)state];

    /// <summary>The condition that a state column has one of the given states. The states are spelled out because the two engines take
    /// lists as parameters in different ways.</summary>
    public static string IsIn(string column, params IEnumerable<CorrectionState> states) =>
        $"{column} IN ({string.Join(", ", states.Select(s => $"'{Word(s)}'"))})";

    public static Correction Read(DbDataReader row) => new(
        row.GetInt64(0),
        State(row.GetString(1)),
        (int)row.GetInt64(2),
        row.GetString(3),
        row.GetString(4),
        StoredTime.From(row.GetInt64(5)),
        row.GetString(7),
        row.GetInt64(8))
    {
        ChangedAt = StoredTime.From(row.GetInt64(6)),
        Job = row.TextOrNull(9),
        Piece = row.TextOrNull(10),
        Serial = row.TextOrNull(11),
        WorkOrder = row.TextOrNull(12),
        Identity = row.TextOrNull(13),
        JobSha256 = row.TextOrNull(14),
        BaseSha256 = row.TextOrNull(15),
        Machine = row.TextOrNull(16),
        Slot = row.TextOrNull(17),
        Program = row.TextOrNull(18),
        ProgramSha256 = row.TextOrNull(19),
        ReportSha256 = row.TextOrNull(20),
        PageSha256 = row.TextOrNull(21),
        LargestMm = row.IsDBNull(22) ? null : row.GetDouble(22),
        SumMm = row.IsDBNull(23) ? null : row.GetDouble(23),
        PreviousSha256 = row.TextOrNull(24),
        Code = row.TextOrNull(25),
        Reason = row.StatementOrNull(26),
        Trace = row.TextOrNull(27),
        PartSha256 = row.TextOrNull(28),
        SumsSha256 = row.TextOrNull(29),
        JobWorkOrder = row.TextOrNull(30),
        MeasuredAs = row.IsDBNull(31) ? null : row.GetInt64(31),
        Offset = row.StatementOrNull(32),
        UndoSha256 = row.TextOrNull(33),
    };

    /// <summary>The correction as the store returns it: texts that a database would reject are made acceptable.</summary>
    public static Correction Stored(Correction correction) => correction with
    {
        Job = StoredText.NameOrNull(correction.Job),
        Piece = StoredText.NameOrNull(correction.Piece),
        Serial = StoredText.NameOrNull(correction.Serial),
        WorkOrder = StoredText.NameOrNull(correction.WorkOrder),
        JobWorkOrder = StoredText.NameOrNull(correction.JobWorkOrder),
        Identity = StoredText.NameOrNull(correction.Identity),
        Machine = StoredText.NameOrNull(correction.Machine),
        Slot = StoredText.NameOrNull(correction.Slot),
        Program = StoredText.NameOrNull(correction.Program),
        Code = StoredText.NameOrNull(correction.Code),
        Reason = StoredText.OfOrNull(correction.Reason),
        Offset = StoredText.OfOrNull(correction.Offset),
        Trace = StoredText.NameOrNull(correction.Trace),
    };

    /// <summary>The parameters of <see cref="Update"/>.</summary>
    public static SqlArguments Parameters(Correction to, CorrectionState from, string? rowCode) => [
        ("Id", to.Id),
        ("State", Word(to.State)),
        ("From", Word(from)),
        ("Version", to.Version),
        ("ChangedAt", StoredTime.Of(to.ChangedAt)),
        ("Job", to.Job),
        ("Piece", to.Piece),
        ("Serial", to.Serial),
        ("WorkOrder", to.WorkOrder),
        ("Identity", to.Identity),
        ("JobSha256", to.JobSha256),
        ("BaseSha256", to.BaseSha256),
        ("Machine", to.Machine),
        ("Slot", to.Slot),
        ("Program", to.Program),
        ("ProgramSha256", to.ProgramSha256),
        ("ReportSha256", to.ReportSha256),
        ("PageSha256", to.PageSha256),
        ("LargestMm", to.LargestMm),
        ("SumMm", to.SumMm),
        ("PreviousSha256", to.PreviousSha256),
        ("Code", to.Code),
        ("Reason", to.Reason?.Text),
        ("Trace", to.Trace),
        ("PartSha256", to.PartSha256),
        ("SumsSha256", to.SumsSha256),
        ("JobWorkOrder", to.JobWorkOrder),
        ("Offset", to.Offset?.Text),
        ("UndoSha256", to.UndoSha256),
        ("RowCode", rowCode),
    ];

    /// <summary>The row in coded form. Without an offset it is that of earlier versions.</summary>
    public static CodedRow Coded(Correction c) => new(NameOf(c.Id),
    [
        Word(c.State), CodedRow.Number(c.Version), c.Gauge, c.FileName, CodedRow.Number(StoredTime.Of(c.ArrivedAt)),
            CodedRow.Number(StoredTime.Of(c.ChangedAt)),
        c.MeasurementSha256, CodedRow.Number(c.MeasurementBytes), c.Job, c.Piece, c.Serial, c.WorkOrder, c.Identity, c.JobSha256,
            c.BaseSha256, c.Machine, c.Slot, c.Program,
        c.ProgramSha256, c.ReportSha256, c.PageSha256, CodedRow.Number(c.LargestMm), CodedRow.Number(c.SumMm), c.PreviousSha256, c.Code,
            c.Reason?.Text, c.Trace, c.PartSha256, c.SumsSha256,
        c.JobWorkOrder, CodedRow.Number(c.MeasuredAs), .. c is { Offset: null, UndoSha256: null }
            ? Array.Empty<string?>() : [c.Offset?.Text, c.UndoSha256],
    ]);

    /// <summary>The row's name among coded rows.</summary>
    public static string NameOf(long id) => NamePrefix + CodedRow.Number(id);

    /// <summary>True if a name is that of a correction's row.</summary>
    public static bool IsName(string name) => name.StartsWith(NamePrefix, StringComparison.Ordinal);

    /// <summary>The row with its code.</summary>
    public static StoredRow<Correction> ReadKept(DbDataReader row) => new(Read(row), Coded, row.TextOrNull(34));

    public static CorrectionStep ReadStep(DbDataReader row) => new(
        row.GetInt64(0),
        row.IsDBNull(1) ? null : State(row.GetString(1)),
        State(row.GetString(2)),
        StoredTime.From(row.GetInt64(3)),
        row.GetString(4),
        Recorded.Read(row.GetString(5)));

    internal static CorrectionState? StateOrNull(string word) => Array.IndexOf(Words, word) is >= 0 and var at ? (CorrectionState)at : null;

    private static CorrectionState State(string word)
    {
        var at = Array.IndexOf(Words, word);
        return at >= 0
            ? (CorrectionState)at
            : throw new StoreException(
                StoreError.Damaged, $"The store has a correction in the state \"{word}\", which is none. Restore the latest backup.");
    }
}
