using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Signs one act: the user gives a reason if one is required, and enters the password again if the act requires it.</summary>
public sealed class SigningViewModel : Observable
{
    private readonly Station _station;
    private readonly Func<SignedIn, string?, CancellationToken, Task> _carryOut;
    private string _reason = "";
    private string _password = "";
    private string? _message;

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
            RunAsync, () => IsRead && (!NeedsReason || !string.IsNullOrWhiteSpace(Reason)) && (!NeedsPassword || Password.Length > 0));
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

    /// <summary>Names the user whose password is required.</summary>
    public string PasswordLabel => Texts.Current.With("Signing.Password", UserName);

    /// <summary>The consequence, in words.</summary>
    public string Consequence => Sentence.Joined(Texts.Current[ConsequenceKey?.Invoke() ?? Key + ".Consequence"], Told?.Invoke() ?? "");

    /// <summary>Signs and performs the act.</summary>
    public LongCommand Confirm { get; }

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

    private async Task RunAsync(CancellationToken cancellation)
    {
        var (password, reason) = (Password, string.IsNullOrWhiteSpace(Reason) ? null : Reason.Trim());
        Message = null;
        try
        {
            await Task.Run(
                async () =>
                {
                    var by = NeedsPassword ? _station.Session.SignAgain(password) : Who;
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
                ? Texts.Current.With("Signing.WrongPassword", UserName)
                : Failures.Of(e, _station.Clock);
        }
        finally
        {
            Password = "";
        }
    }
}
