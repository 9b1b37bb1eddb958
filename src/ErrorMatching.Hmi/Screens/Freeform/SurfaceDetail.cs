namespace ErrorMatching.Hmi;

/// <summary>All details of one measured surface.</summary>
internal sealed class SurfaceDetail
{
    private readonly StoredCorrection _kept;
    private readonly TimeProvider _clock;

    /// <summary>Formats the details. Slow; may run off the UI thread.</summary>
    /// <param name="kept">The stored correction, with the report of a surface.</param>
    /// <param name="clock">Gives the time zone.</param>
    public SurfaceDetail(StoredCorrection kept, TimeProvider clock)
    {
        (_kept, _clock) = (kept ?? throw new ArgumentNullException(nameof(kept)), clock);
        Figures = new(
            kept.Surface ?? throw new ArgumentException("The correction has no report of a surface.", nameof(kept)),
            kept.Correction.IsToBeCut);
    }

    /// <summary>Number and serial number or file.</summary>
    public string Title => CorrectionLabel.Of(_kept.Correction);

    public string State => Texts.Current.Word(_kept.Correction.State);

    /// <summary>The workpiece's name.</summary>
    public string Job => _kept.Surface!.JobName;

    /// <summary>Work order, gauge, file and time in one line.</summary>
    public string Origin => string.Join(
        " · ",
        new[]
        {
            _kept.Correction.WorkOrder,
            _kept.Correction.Gauge,
            _kept.Correction.FileName,
            Shown.Time(_kept.Correction.ArrivedAt, _clock)
        }.Where(t => !string.IsNullOrEmpty(t)));

    /// <summary>What the machine needs and the program lacks, in words; null if nothing.</summary>
    public string? Missing => _kept.Missing;

    /// <summary>Its results and drawings.</summary>
    public SurfaceFigures Figures { get; }

    /// <summary>The finishing program, line by line.</summary>
    public ProgramLines? Lines => _kept.Lines;

    /// <summary>Name and size of the finishing program.</summary>
    public string ProgramCaption =>
        Lines is { } lines
            ? Texts.Current.With("Freeform.ProgramSize", _kept.Correction.Program ?? "", Shown.Count(lines.Count), Shown.Count(lines.Bytes))
            : "";
}
