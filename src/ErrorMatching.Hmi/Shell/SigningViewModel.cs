using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Signs one act: the user gives a reason if one is required, and the password, PIN or badge again if the act requires
/// it.</summary>
public sealed class SigningViewModel : Observable, ITakesCodes
{
    private readonly Station _station;
    private readonly Func<SignedIn, string?, CancellationToken, Task> _carryOut;
    private string _reason = "";
    private string _password = "";
    private string? _message;
    private string? _badge;

    /// <summary>Asks for a signature.</summary>
    /// <param name="station">The station.</param>
    /// <param name="who">The signed-in user.</param>
    /// <param name="act">The act.</param>
    /// <param name="subject">What it applies to, in words.</param>
    /// <param name="needsReason">True if a reason is required.</param>
    /// <param name="carryOut">Performs the act off the UI thread, given the signer and the reason.</param>
    public SigningViewModel(
        Station station, SignedIn who, Act act, string subject, bool needsReason, Func<SignedIn, string?, CancellationToken, Task> carryOut)
    {
        ArgumentNullException.ThrowIfNull(who);
        (_station, _carryOut) = (station, carryOut);
        (Act, Subject, UserName, NeedsReason, NeedsPassword) = (act, subject, who.Name, needsReason, Rights.IsSigned(act));
        Who = who;
        Confirm = new(
            c => RunAsync(NeedsPassword ? Password : null, c),
            () => IsRead && (!NeedsReason || !string.IsNullOrWhiteSpace(Reason)) && (!NeedsPassword || Password.Length > 0));
        ByBadge = new(c => RunAsync(null, c));
        Leave = new(() => Done?.Invoke());
    }

    /// <summary>Raised when the act is signed and done, or the dialog is canceled.</summary>
    public event Action? Done;

    /// <summary>Raised when the act is signed and done, before <see cref="Done"/>.</summary>
    public event Action? Signed;

    public Act Act { get; }

    /// <summary>Key of the text for the act; the key with <c>.Consequence</c> appended has the consequence. Null for the act's
    /// own key.</summary>
    public string? TitleKey { get; init; }

    /// <summary>Returns the key of the consequence if it depends on the situation; null for the one of <see cref="TitleKey"/>.</summary>
    public Func<string>? ConsequenceKey { get; init; }

    /// <summary>True if the called code demands the right and the signature itself: a signature is valid for one act only.</summary>
    public bool IsDemandedElsewhere { get; init; }

    /// <summary>Returns further information; null if there is none.</summary>
    public Func<string>? Told { get; init; }

    /// <summary>Returns what the user should know about the subject, as shown behind the dialog; null for nothing.</summary>
    public Func<IReadOnlyList<Fact>>? Known { get; init; }

    /// <summary>What the user should know before signing.</summary>
    public IReadOnlyList<Fact> Facts => Known?.Invoke() ?? [];

    /// <summary>What the act applies to.</summary>
    public string Subject { get; }

    /// <summary>The correction that the act applies to; null for anything else.</summary>
    public Correction? Correction { get; init; }

    /// <summary>Where its program goes or is; null if none goes to a machine, for example because it is rejected.</summary>
    public string? Target => Correction is { } correction && Act != Act.Reject ? CorrectionLabel.Target(correction) : null;

    /// <summary>Name of the signer.</summary>
    public string UserName { get; }

    public bool NeedsReason { get; }

    public bool NeedsPassword { get; }

    /// <summary>The act, in words.</summary>
    public string Title => Texts.Current[Key];

    /// <summary>Names the user whose password, PIN or badge is required.</summary>
    public string PasswordLabel => Texts.Current.With(
        _station.Session.Ways switch
        {
            _ when _badge is not null => "Signing.Pin",
            var ways when ways.HasFlag(SignInWays.Badge) => "Signing.PasswordOrBadge",
            var ways when ways.HasFlag(SignInWays.Pin) => "Signing.PasswordOrPin",
            var ways when ways.HasFlag(SignInWays.BadgeWithPin) => "Signing.PasswordOrBadgeAndPin",
            _ => "Signing.Password",
        },
        UserName);

    /// <summary>True if a PIN counts, alone or with a badge.</summary>
    public bool TakesPin => _station.Session.TakesPins;

    /// <summary>The shop's reasons, to tap instead of typing; empty for other acts than a rejection.</summary>
    public IReadOnlyList<RejectionReason> Reasons => Act == Act.Reject && NeedsReason
        ? [.. _station.Settings.RejectionReasons.Select((r, i) => new RejectionReason(r, i, new(() => Reason = r)))] : [];

    /// <summary>The consequence, in words.</summary>
    public string Consequence => Sentence.Joined(Texts.Current[ConsequenceKey?.Invoke() ?? Key + ".Consequence"], Told?.Invoke() ?? "");

    /// <summary>Signs and performs the act.</summary>
    public LongCommand Confirm { get; }

    /// <summary>Takes a scanned badge: it signs, or the PIN is asked next. What it was typed into is emptied.</summary>
    public void TakeCode(string code)
    {
        Password = "";

        // A reason is recorded, and a badge must not be: of a scanner that acts as a keyboard, it was typed into what had the focus.
        if (Reason.LastIndexOf(code, StringComparison.Ordinal) is >= 0 and var at)
        {
            Reason = Reason.Remove(at, code.Length);
        }

        if (!_station.Session.Ways.HasFlag(SignInWays.Badge))
        {
            _badge = code;
            Message = null;
            OnPropertyChanged(nameof(PasswordLabel));
        }
        else if (!IsRead || (NeedsReason && string.IsNullOrWhiteSpace(Reason)))
        {
            Message = Texts.Current[IsRead ? "Signing.ReasonFirst" : "Signing.ReadFirst"];
        }
        else if (!Confirm.IsRunning)
        {
            _badge = code;
            ByBadge.Execute(null);
        }
    }

    /// <summary>Signs by the badge alone, and performs the act.</summary>
    internal LongCommand ByBadge { get; }

    /// <summary>Cancels without any change.</summary>
    public Command Leave { get; }

    /// <summary>True if everything that the user signs for was on the screen. Until then nothing is signed.</summary>
    public bool IsRead { get; private set; }

    /// <summary>True if the user must scroll to read the rest.</summary>
    public bool MustScroll { get; private set; }

    /// <summary>Call it when the dialog is on the screen, and when it has scrolled.</summary>
    /// <param name="isEnd">True if the end of what must be read is visible.</param>
    public void See(bool isEnd)
    {
        if (!IsRead)
        {
            (IsRead, MustScroll) = (isEnd, !isEnd);
            OnPropertyChanged(nameof(MustScroll));
            Confirm.Refresh();
        }
    }

    public string Reason
    {
        get => _reason;
        set
        {
            if (Set(ref _reason, value ?? ""))
            {
                Confirm.Refresh();
            }
        }
    }

    public string Password
    {
        get => _password;
        set
        {
            if (Set(ref _password, value ?? ""))
            {
                Confirm.Refresh();
            }
        }
    }

    /// <summary>The error message; null if there is none.</summary>
    public string? Message
    {
        get => _message;
        private set => Set(ref _message, value);
    }

    /// <summary>Updates all texts after a change of language.</summary>
    internal void Translate()
    {
        OnPropertyChanged(nameof(Title));
        OnPropertyChanged(nameof(Facts));
        OnPropertyChanged(nameof(Consequence));
        OnPropertyChanged(nameof(PasswordLabel));
        OnPropertyChanged(nameof(Target));
    }

    private SignedIn Who { get; }

    private string Key => TitleKey ?? "Act." + Act;

    // Without a secret, the badge alone signs.
    private async Task RunAsync(string? secret, CancellationToken cancellation)
    {
        var (badge, reason) = (_badge, string.IsNullOrWhiteSpace(Reason) ? null : Reason.Trim());
        Message = null;
        try
        {
            await Task.Run(
                async () =>
                {
                    var by = !NeedsPassword ? Who
                        : badge is null ? _station.Session.SignAgain(secret!)
                        : _station.Session.SignAgainByBadge(badge, secret);
                    if (!IsDemandedElsewhere)
                    {
                        _station.Users.Demand(by, Act);
                    }

                    await _carryOut(by, reason, cancellation);
                },
                cancellation);
            Signed?.Invoke();
            Done?.Invoke();
        }
        catch (Exception e) when (Failures.IsKnown(e))
        {
            // This dialog does not ask for a user name.
            Message = e is PeopleException { Error: PeopleError.SignInRefused }
                ? Texts.Current.With(badge is not null && secret is null ? "Signing.WrongBadge" : "Signing.WrongPassword", UserName)
                : e is PeopleException { Error: PeopleError.NotSigned } && badge is not null
                ? Texts.Current.With("Signing.OtherBadge", UserName)
                : Failures.Of(e, _station.Clock);
        }
        finally
        {
            (_badge, Password) = (null, "");
            OnPropertyChanged(nameof(PasswordLabel));
        }
    }
}

/// <summary>A reason for a rejection, to tap.</summary>
/// <param name="Text">The reason, as the shop puts it.</param>
/// <param name="Number">Its place in the list, from 0.</param>
/// <param name="Take">Takes it as the reason.</param>
public sealed record RejectionReason(string Text, int Number, Command Take)
{
    public string AutomationId => string.Create(System.Globalization.CultureInfo.InvariantCulture, $"signing-reason-{Number}");
}
