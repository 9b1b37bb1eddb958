using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>All details of one measured surface.</summary>
internal sealed class SurfaceDetail : Observable
{
    private readonly TimeProvider _clock;
    private readonly Func<SurfacePath> _readPath;
    private SurfacePath? _path;
    private bool _isPathShown;
    private string? _pathTrouble;

    /// <summary>Formats the details. Slow; may run off the UI thread.</summary>
    /// <param name="kept">The stored correction, with the report of a surface.</param>
    /// <param name="clock">Gives the time zone.</param>
    /// <param name="readPath">Reads the passes of its program, off the UI thread.</param>
    public SurfaceDetail(StoredCorrection kept, TimeProvider clock, Func<SurfacePath> readPath)
    {
        (Stored, _clock, _readPath) = (kept ?? throw new ArgumentNullException(nameof(kept)), clock, readPath);
        Figures = new(
            kept.Surface ?? throw new ArgumentException("The correction has no report of a surface.", nameof(kept)),
            kept.Correction.IsToBeCut);
        Sections = SurfaceSections.Of(Figures.Measured, null);
    }

    public StoredCorrection Stored { get; }

    /// <summary>The language of its texts.</summary>
    public Language Language { get; } = Texts.Current.Language;

    /// <summary>The same in the current display language, which may have changed while this was being formatted.</summary>
    public SurfaceDetail Now() =>
        Language == Texts.Current.Language ? this : new(Stored, _clock, _readPath) { IsOfChangedJob = IsOfChangedJob };

    /// <summary>True if it waits, and its job was changed after it was computed.</summary>
    public bool IsOfChangedJob { get; init; }

    /// <summary>Number and serial number or file.</summary>
    public string Title => CorrectionLabel.Of(Stored.Correction);

    public string State => Texts.Current.Word(Stored.Correction.State);

    /// <summary>The workpiece's name.</summary>
    public string Job => Stored.Surface!.JobName;

    /// <summary>Work order, gauge, file and time in one line.</summary>
    public string Origin => string.Join(
        " · ",
        new[]
        {
            Stored.Correction.WorkOrder,
            Stored.Correction.Gauge,
            Stored.Correction.FileName,
            Shown.Time(Stored.Correction.ArrivedAt, _clock)
        }.Where(t => !string.IsNullOrEmpty(t)));

    /// <summary>What the machine needs and the program lacks, in words; null if nothing.</summary>
    public string? Missing => Stored.Missing;

    /// <summary>True if a proof of its program fails.</summary>
    public bool IsDisproved => Figures.ProofSeverity == Severity.Alarm;

    /// <summary>Its results and drawings.</summary>
    public SurfaceFigures Figures { get; }

    /// <summary>How many warnings there are, and where.</summary>
    public string WarningCount => Texts.Current.With("Head.Warnings", Figures.Warnings.Count);

    /// <summary>What the approver signs for, as in the on-line compensation.</summary>
    public IReadOnlyList<Fact> Facts => [.. new[]
    {
        Figures.IsJudged ? new Fact(Figures.Verdict, Figures.VerdictSeverity) : null,
        IsDisproved ? new(Figures.Proof, Severity.Alarm) : null,
        Stored.Correction.Offset is { } offset ? new(RecordedText.Of(offset, Stored.Correction), Severity.Quiet) : null,
        Largest is { } largest ? new(largest, Severity.Quiet) : null,
        Missing is { } missing ? new(missing, Severity.Attention) : null,
        IsOfChangedJob ? new(Texts.Current["Head.ChangedJob"], Severity.Attention) : null,
        Figures.HasWarnings ? new(WarningCount, Severity.Attention) : null,
    }.OfType<Fact>()];

    /// <summary>The place of the sections, as tapped on the map; null for the worst place.</summary>
    public Point2? Place
    {
        get;
        set
        {
            if (Set(ref field, value))
            {
                Sections = SurfaceSections.Of(Figures.Measured, value);
                OnPropertyChanged(nameof(Sections));
                OnPropertyChanged(nameof(SectionUCaption));
                OnPropertyChanged(nameof(SectionVCaption));
            }
        }
    }

    /// <summary>The measured error along the two lines through the place.</summary>
    public SurfaceSections? Sections { get; private set; }

    /// <summary>Whose place the sections go through, and the error there.</summary>
    public string SectionUCaption => Sections is { } sections
        ? Texts.Current.With(
            sections.IsWorst ? "Freeform.SectionWorst" : "Freeform.SectionTapped", Shown.SignedMicrometers(sections.ValueMm))
        : "";

    /// <summary>Where that place is.</summary>
    public string SectionVCaption => Sections is { At: var at }
        ? Texts.Current.With("Freeform.SectionAt", Shown.Number(at.X), Shown.Number(at.Y))
        : "";

    /// <summary>True if the program's passes are drawn over the map.</summary>
    public bool IsPathShown
    {
        get => _isPathShown;
        set
        {
            if (Set(ref _isPathShown, value))
            {
                OnPropertyChanged(nameof(Path));
                ReadingPath = value && _path is null ? ReadPathAsync().Watched() : ReadingPath;
            }
        }
    }

    /// <summary>True if there is a program.</summary>
    public bool HasPath => Stored.Correction.ProgramSha256 is not null;

    /// <summary>The program's passes seen from above; null if they are not shown.</summary>
    public SurfacePath? Path => IsPathShown ? _path : null;

    /// <summary>Why the passes cannot be shown; null if they can.</summary>
    public string? PathTrouble
    {
        get => _pathTrouble;
        private set => Set(ref _pathTrouble, value);
    }

    /// <summary>Completes when the passes are read.</summary>
    internal Task ReadingPath { get; private set; } = Task.CompletedTask;

    /// <summary>The finishing program, line by line.</summary>
    public ProgramLines? Lines => Stored.Lines;

    /// <summary>Name and size of the finishing program.</summary>
    public string ProgramCaption =>
        Lines is { } lines
            ? Texts.Current.With(
                "Freeform.ProgramSize", Stored.Correction.Program ?? "", Shown.Count(lines.Count), Shown.Count(lines.Bytes))
            : "";

    private string? Largest =>
        Stored.Correction.LargestMm is not > 0
            ? null
            : (Stored.TriedAt is { } at ? StoredMove.PlaceOf(at) : StoredMove.PlaceOf(Stored.Steps)) is { } place
        ? Texts.Current.With("Head.LargestAt", Shown.Mm(Stored.Correction.LargestMm), place)
        : Texts.Current.With("Head.Largest", Shown.Mm(Stored.Correction.LargestMm));

    private async Task ReadPathAsync()
    {
        SurfacePath? path = null;
        PathTrouble = await Failures.OfAsync(() => path = _readPath(), _clock);
        _path = path;
        OnPropertyChanged(nameof(Path));
    }
}
