using System.Text.RegularExpressions;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Messages and audit trail: what happened, what to do next, and whether the trail is intact.</summary>
internal sealed partial class MessagesViewModel : ScreenViewModel
{
    private const int Page = 200;

    // More than anybody reads at once: all corrections that wait are in the on-line compensation.
    private const int Most = 100;

    private const int Digits = 8;
    private readonly Action<long> _look;
    private readonly Action<long> _lookAtPiece;
    private IReadOnlyList<AuditEntry> _entries = [];
    private long _newest = -1;
    private bool _isReading;
    private AuditFinding? _finding;

    /// <summary>Creates the screen.</summary>
    /// <param name="station">The station.</param>
    /// <param name="look">Opens a correction.</param>
    /// <param name="lookAtPiece">Opens the verification of a measured piece.</param>
    /// <param name="lookAtAll">Opens the list of all corrections.</param>
    public MessagesViewModel(Station station, Action<long> look, Action<long> lookAtPiece, Action lookAtAll)
        : base(station)
    {
        (_look, _lookAtPiece, LookAtAll) = (look, lookAtPiece, new(lookAtAll));
        Verify = new(async cancellation =>
        {
            AuditFinding? finding = null;
            if (await TryAsync(() => finding = new AuditTrail(Station.Store, Station.Settings).Verify(null, cancellation)))
            {
                _finding = finding;
                OnPropertyChanged(nameof(Finding));
                OnPropertyChanged(nameof(FindingSeverity));
            }
        });
        More = new(_ => ReadAsync(_entries.Count + Page), () => _entries.Count > 0 && _entries[^1].Seq > 1);
        Refresh();
    }

    /// <summary>Messages, worst first: the first hundred.</summary>
    public RowList<MessageRow> Messages { get; } = [];

    /// <summary>How many more there are, and where their corrections are listed; null if <see cref="Messages"/> has all.</summary>
    public string? Left { get; private set; }

    /// <summary>Opens the list of all corrections.</summary>
    public Command LookAtAll { get; }

    /// <summary>True if there are known to be no messages.</summary>
    public bool IsQuiet => Station.State is { Status: not null, StoreTrouble: null } && Messages.Count == 0;

    /// <summary>The audit trail, latest first.</summary>
    public RowList<TrailRow> Entries { get; } = [];

    /// <summary>Verifies every entry of the trail.</summary>
    public LongCommand Verify { get; }

    /// <summary>Shows older entries as well.</summary>
    public LongCommand More { get; }

    /// <summary>The result of verifying; null before.</summary>
    public string? Finding => _finding switch
    {
        null => null,
        { Fault: { } fault } => Texts.Current.With("Audit.Fault", Shown.Id(fault.Seq), Texts.Current.Word(fault.Kind)),
        { IsSealChecked: false } => Texts.Current.With("Audit.HoldsUnsealed", Shown.Count(_finding.Entries)),
        _ => Texts.Current.With("Audit.Holds", Shown.Count(_finding.Entries)),
    };

    /// <summary>A broken trail is an alarm.</summary>
    public Severity FindingSeverity =>
        _finding switch { { Fault: not null } => Severity.Alarm, { IsSealChecked: false } => Severity.Attention, _ => Severity.Quiet };

    /// <summary>Completes when the trail is read.</summary>
    internal Task Reading { get; private set; } = Task.CompletedTask;

    /// <summary>Opens the subject of a message.</summary>
    public void Look(MessageRow message)
    {
        if (message?.Correction is { } correction)
        {
            (message.IsMeasured ? _lookAtPiece : _look)(correction);
        }
    }

    /// <inheritdoc/>
    protected override void Follow() => Refresh();

    /// <inheritdoc/>
    protected override void Translate()
    {
        Refresh();
        Entries.Show([.. _entries.Select(Row)]);
        OnPropertyChanged();
    }

    private void Refresh()
    {
        if (Station.State.Status is { } status)
        {
            Func<MessageRow>[] all = [.. Of(status)];
            Messages.Show([.. all.Take(Most).Select(m => m())]);
            Left = all.Length > Most ? Texts.Current.With("Message.More", Shown.Count(all.Length - Most)) : null;
            OnPropertyChanged(nameof(Left));
        }

        OnPropertyChanged(nameof(IsQuiet));

        if (!_isReading)
        {
            Reading = ReadAsync(Math.Max(Page, _entries.Count)).Watched();
        }
    }

    private static string NextOf(CellTrouble trouble) => trouble.Code == CellCodes.ChangedAtMachine ? "Message.Changed.Next"
        : "Message.Trouble.Next";

    // Made only if they are listed.
    private IEnumerable<Func<MessageRow>> Of(CellStatus status)
    {
        var texts = Texts.Current;
        if (!status.IsRunning)
        {
            yield return () => new(
                Severity.Alarm,
                status.Heartbeat is { } last
                    ? texts.With("Message.NotRunningSince", Shown.Time(last.At, Station.Clock))
                    : texts["Message.NotRunning"],
                texts["Message.NotRunning.Next"],
                null);
        }

        foreach (var trouble in status.IsRunning ? status.Heartbeat!.Troubles : [])
        {
            var (where, since, what) = (
                CodeText.Where(trouble.Where), Shown.Time(trouble.Since, Station.Clock), CodeText.Of(trouble.Code, trouble.Statement));
            yield return () => new(Severity.Alarm, $"{where} · {since} · {what}", texts[NextOf(trouble)], null);
        }

        // A running cell reports this itself.
        foreach (var tampered in status.IsRunning ? [] : status.Tampered)
        {
            yield return () => new(Severity.Alarm, RecordedText.Of(tampered), texts["Message.Trouble.Next"], null);
        }

        foreach (var failed in status.Failed)
        {
            yield return () => new(
                Severity.Alarm,
                $"{CorrectionLabel.Of(failed)} · {(failed.Code is { } code ? CodeText.Of(code, failed.Reason) : failed.Reason?.Sentence)}",
                texts[failed.ProgramSha256 is null ? "Message.FailedUncomputed.Next" : "Message.Failed.Next"],
                failed.Id);
        }

        foreach (var outside in OutsidePieces.Of(Station.Outside))
        {
            var newest = outside.Newest;
            yield return () => new(
                Severity.Attention,
                string.Join(
                    '\n',
                    new[]
                    {
                        texts.With("Message.Outside", CorrectionLabel.Of(newest.Counterpart!), PieceDetail.VerdictOf(newest)),
                        outside.Others
                    }.OfType<string>()),
                texts["Message.Outside.Next"],
                newest.LastId)
            {
                IsMeasured = true,
            };
        }

        foreach (var (slot, up) in status.Slots.SelectMany(s => s.HeldUp.Select(h => (s, h))))
        {
            yield return () => new(
                Severity.Attention,
                texts.With(
                    "Message.HeldUp",
                    CorrectionLabel.Of(up.Correction),
                    $"{slot.Machine.Name}/{slot.Slot.Name}",
                    WaitReason.Numbers(up.Behind)),
                texts["Message.HeldUp.Next"],
                up.Behind[0].Id)
            {
                AutomationId = "message-held-up-" + Shown.Id(up.Correction.Id),
            };
        }

        foreach (var proposed in status.Proposed)
        {
            yield return () => new(
                Severity.Attention,
                texts.With("Message.Proposed", CorrectionLabel.Of(proposed), Shown.Mm(proposed.LargestMm)),
                texts["Message.Proposed.Next"],
                proposed.Id);
        }

        foreach (var slot in status.Slots.Where(
            s => s.Held is { WaitsForRelease: true, State: var state } && (state != CorrectionState.Verified || s.Slot.ReadyFile is null)))
        {
            var (name, held) = ($"{slot.Machine.Name}/{slot.Slot.Name}", CorrectionLabel.Of(slot.Held!));
            yield return () => slot.Held!.State == CorrectionState.Reverted
                ? new(Severity.Attention, texts.With("Message.TakenBack", name, held), texts["Message.TakenBack.Next"], slot.Held.Id)
                : new(Severity.Attention, texts.With("Message.Taken", name, held), texts["Message.Taken.Next"], slot.Held.Id);
        }
    }

    private async Task ReadAsync(int most)
    {
        _isReading = true;
        try
        {
            IReadOnlyList<AuditEntry>? entries = null;
            var (newest, known) = (_newest, _entries.Count);
            if (await TryAsync(() =>
            {
                var head = Station.Store.ChangeCount();
                if (head != newest || most > known)
                {
                    entries = Station.Store.AuditEntries(Math.Max(0, head - most), most);
                }
            }) && entries is not null)
            {
                _entries = [.. entries.OrderByDescending(e => e.Seq)];
                _newest = _entries is [var first, ..] ? first.Seq : 0;
                Entries.Show([.. _entries.Select(Row)]);
                More.Refresh();
            }
        }
        finally
        {
            _isReading = false;
        }
    }

    private TrailRow Row(AuditEntry entry) => new(
        Shown.Id(entry.Seq),
        Shown.Time(entry.At, Station.Clock),
        RecordedText.Who(entry.Who),
        Texts.Current.Or("Audited." + entry.What, entry.What),
        Short(RecordedText.Of(entry.Subject ?? "")),
        Short(RecordedText.Of(entry.Basis)));

    // The first digits identify a hash; the export has the whole one.
    private static string Short(string text) => Hash().Replace(text, m => m.Value[..Digits] + "…");

    [GeneratedRegex("[0-9a-f]{64}", RegexOptions.None, Timeout.Infinite)]
    private static partial Regex Hash();
}

/// <summary>A message to the user, with what to do next.</summary>
/// <param name="Severity">Its severity.</param>
/// <param name="What">The situation.</param>
/// <param name="Next">What to do.</param>
/// <param name="Correction">The correction to open; null if there is none.</param>
internal sealed record MessageRow(Severity Severity, string What, string Next, long? Correction)
{
    /// <summary>True to open the verification of a measured piece instead.</summary>
    public bool IsMeasured { get; init; }

    /// <summary>True if a tap opens something.</summary>
    public bool CanLook => Correction is not null;

    public string AutomationId { get; init; } = Correction is { } id ? "message-" + Shown.Id(id) : "message";
}

/// <summary>A displayed entry of the audit trail.</summary>
/// <param name="Number">Its number.</param>
/// <param name="Time">Its time.</param>
/// <param name="Who">Who acted.</param>
/// <param name="What">The act.</param>
/// <param name="Subject">What it applied to.</param>
/// <param name="Basis">Its basis.</param>
public sealed record TrailRow(string Number, string Time, string Who, string What, string Subject, string Basis)
{
    // About two lines of its column.
    private const int LongBasis = 100;

    /// <summary>The basis; if it is long, only its first sentence.</summary>
    public string Short =>
        Basis.Length > LongBasis && Sentence.First(Basis) is { } first && first.Length < Basis.Length ? first + " …" : Basis;
}
