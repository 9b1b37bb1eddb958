namespace ErrorMatching.Hmi;

/// <summary>Verification: whether the compensation worked as predicted, by point, assembly and feature, and from piece to piece.</summary>
internal sealed class VerificationViewModel : ScreenViewModel, ILooksAt
{
    private readonly StoredPieces _kept = new();
    private readonly ShellViewModel _shell;
    private MatingChoice? _mating;
    private PieceRow? _chosen;
    private long? _looked;
    private long? _sought;
    private PieceDetail? _detail;
    private IReadOnlyList<StoredPiece> _pieces = [];
    private string _shown = "";
    private int _load;
    private long _older;

    public VerificationViewModel(ShellViewModel shell)
        : base((shell ?? throw new ArgumentNullException(nameof(shell))).Station)
    {
        _shell = shell;
        Matings = MatingChoice.Of(Station.Settings);
        _mating = Matings.FirstOrDefault(m => m.Name == shell.Looked.Mating) ?? (Matings is [var first, ..] ? first : null);
        _sought = _looked = shell.Looked.Piece;
        Refresh();
    }

    /// <summary>The cell's matings.</summary>
    public IReadOnlyList<MatingChoice> Matings { get; }

    /// <summary>True if there is a choice.</summary>
    public bool HasMatings => Matings.Count > 1;

    /// <summary>The selected mating.</summary>
    public MatingChoice? Mating
    {
        get => _mating;
        set
        {
            if (value is not null && Set(ref _mating, value))
            {
                (_looked, _sought, _shown) = (null, null, "");
                (_shell.Looked.Mating, _shell.Looked.Piece) = (value.Name, null);
                Refresh();
            }
        }
    }

    /// <summary>The last pieces, newest first.</summary>
    public RowList<PieceRow> Rows { get; } = [];

    /// <summary>How many earlier measurements are not listed, in words; null if none.</summary>
    public string? Older => _older > 0 ? Texts.Current.With("List.Older", Shown.Count(_older)) : null;

    /// <summary>True once the list is known to be empty.</summary>
    public bool IsEmpty { get; private set; }

    /// <summary>The selected piece. Until the user selects one, here or among the corrections, it is the one whose counterpart
    /// was measured last; without any, the one that arrived last.</summary>
    public PieceRow? Chosen
    {
        get => _chosen;
        set
        {
            if (value is not null && value != _chosen)
            {
                _shell.Looked.Piece = _looked = value.Id;
                Show(_pieces);
            }
        }
    }

    /// <summary>Its details; null if there is none.</summary>
    public PieceDetail? Detail
    {
        get => _detail;
        private set => Set(ref _detail, value);
    }

    /// <summary>Completes when the content is shown.</summary>
    internal Task Loading { get; private set; } = Task.CompletedTask;

    /// <inheritdoc/>
    public void LookAt(long correction)
    {
        _shell.Looked.Piece = _sought = _looked = correction;
        Refresh();
    }

    /// <inheritdoc/>
    protected override void Follow() => Refresh();

    /// <inheritdoc/>
    protected override void Translate()
    {
        // Rebuild the view in the other language.
        var isKnown = _shown.Length > 0;
        _shown = "";
        Show(_pieces, isKnown);
    }

    private void Refresh() => Loading = LoadAsync(++_load).Watched();

    private async Task LoadAsync(int load)
    {
        IReadOnlyList<StoredPiece>? pieces = null;
        var (mating, sought, older) = (_mating, _sought, 0L);
        var isRead = await TryAsync(() =>
        {
            // The piece selected on another screen may belong to another mating.
            mating = sought is { } id && Station.Store.Find(id)?.Job is { } job
                ? Matings.FirstOrDefault(m => m.Jobs.Contains(job, StringComparer.Ordinal)) ?? mating
                : mating;
            pieces = _kept.Read(Station.Store, mating?.Jobs ?? [], StoredPieces.Most);
            older = Station.Store.Corrections.CountReported(mating?.Jobs ?? []) - StoredPieces.Most;
        });
        if (load != _load)
        {
            return;
        }

        if (isRead)
        {
            _sought = null;
            Set(ref _mating, mating, nameof(Mating));
            _older = older;
            Show(pieces!);
        }
        else if (_shown.Length == 0 || _pieces.Count == 0)
        {
            // The old pieces belong to the other mating, and whether this one has any is not known yet.
            Show([], isKnown: false);
        }
    }

    private void Show(IReadOnlyList<StoredPiece> pieces, bool isKnown = true)
    {
        _pieces = pieces;
        Rows.Show([.. pieces.Reverse().Select(Row)]);
        IsEmpty = isKnown && pieces.Count == 0;
        OnPropertyChanged(nameof(IsEmpty));
        OnPropertyChanged(nameof(Older));
        var chosen = _looked is { } looked ? pieces.FirstOrDefault(p => p.Correction.Id == looked || p.Counterpart?.Id == looked) : null;
        var piece = chosen ?? pieces.Where(p => p.IsMeasured).MaxBy(p => p.LastId) ?? pieces.MaxBy(p => p.LastId);
        _chosen = piece is null ? null : Rows.First(r => r.Id == piece.Correction.Id);
        OnPropertyChanged(nameof(Chosen));

        // The same pieces give the same drawings; keep them, so that a zoomed view stays.
        var shown = !isKnown ? "" : $"{piece?.Correction.Id} of {string.Join(',', pieces.Select(p => p.LastId))}";
        if (shown != _shown || !isKnown)
        {
            _shown = shown;
            Detail = piece is null ? null : new(piece, pieces) { ReadWarnings = new(() => LookAtWarnings(piece.Correction.Id)) };
        }

        if (Detail is { } detail && piece is { IsMeasured: false })
        {
            detail.Follow(piece.Correction, NextStep.Of(Station.Settings, Station.State.Status, piece.Correction));
        }

        // Not if the screen is only being rehearsed.
        if (piece is { IsMeasured: true } && _shell.Current == this)
        {
            Station.See(piece);
        }
    }

    private void LookAtWarnings(long correction) =>
        _shell.Open(ScreenKeys.Compensation, s => (s as CompensationViewModel)?.LookAtWarnings(correction));

    private static PieceRow Row(StoredPiece piece) =>
        new(
            piece.Correction.Id,
            CorrectionLabel.Of(piece.Correction),
            piece.JobName,
            PieceDetail.KindOf(piece),
            Shown.Mm(piece.Result.MaxAfterMm, piece.LargestInterval95Mm),
            PieceDetail.SeverityOf(piece));
}

/// <summary>A piece in a list.</summary>
/// <param name="Id">Number of its correction.</param>
/// <param name="Title">Number and serial number or file.</param>
/// <param name="Job">The workpiece's name.</param>
/// <param name="Kind">Measured or predicted.</param>
/// <param name="Largest">The largest mating error with compensation.</param>
/// <param name="Severity">Alarm if a measured error is outside its limits, attention if a predicted one is.</param>
internal sealed record PieceRow(long Id, string Title, string Job, string Kind, string Largest, Severity Severity)
{
    public string AutomationId => "piece-" + Shown.Id(Id);
}
