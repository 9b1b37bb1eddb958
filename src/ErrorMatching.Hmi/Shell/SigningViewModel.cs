using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A person puts the name under one act: says why where that is asked, gives the password again where the act takes one.</summary>
public sealed class SigningViewModel : Observable
{
    private readonly Station _station;
    private readonly Func<SignedIn, string?, CancellationToken, Task> _carryOut;
    private string _reason = "";
    private string _password = "";
    private string? _message;

    /// <summary>Asks for a signature.</summary>
    /// <param name="station">The station.</param>
    /// <param name="who">Who is signed in.</param>
    /// <param name="act">What is to be done.</param>
    /// <param name="subject">What it is done to, in words.</param>
    /// <param name="needsReason">True if it takes a reason.</param>
    /// <param name="carryOut">Does it, beside the screen: who signs, and why.</param>
    public SigningViewModel(Station station, SignedIn who, Act act, string subject, bool needsReason, Func<SignedIn, string?, CancellationToken, Task> carryOut)
    {
        ArgumentNullException.ThrowIfNull(who);
        (_station, _carryOut) = (station, carryOut);
        (Act, Subject, UserName, NeedsReason, NeedsPassword) = (act, subject, who.Name, needsReason, Rights.IsSigned(act));
        Who = who;
        Confirm = new(RunAsync, () => (!NeedsReason || !string.IsNullOrWhiteSpace(Reason)) && (!NeedsPassword || Password.Length > 0));
        Leave = new(() => Done?.Invoke());
    }

    /// <summary>Said when it is signed and done, or left.</summary>
    public event Action? Done;

    /// <summary>Said when it is signed and done, before <see cref="Done"/>.</summary>
    public event Action? Signed;

    /// <summary>What is to be done.</summary>
    public Act Act { get; }

    /// <summary>Key of the text that says what is to be done, and with <c>.Consequence</c> what follows; that of the act if null.</summary>
    public string? TitleKey { get; init; }

    /// <summary>Gives the key of the text that says what follows, where that hangs on how things are; that of <see cref="TitleKey"/> if null.</summary>
    public Func<string>? ConsequenceKey { get; init; }

    /// <summary>True where what is carried out demands the right and the signature itself: a signature is good for one act.</summary>
    public bool IsDemandedElsewhere { get; init; }

    /// <summary>Gives what else there is to know, in words; null if nothing.</summary>
    public Func<string>? Told { get; init; }

    /// <summary>Gives what a person should know of that to which it is done, as it is seen behind the dialog; nothing if null.</summary>
    public Func<IReadOnlyList<Fact>>? Known { get; init; }

    /// <summary>What a person should know before signing.</summary>
    public IReadOnlyList<Fact> Facts => Known?.Invoke() ?? [];

    /// <summary>What it is done to.</summary>
    public string Subject { get; }

    /// <summary>The correction that it is done to; null for anything else.</summary>
    public Correction? Correction { get; init; }

    /// <summary>Where its program goes or is; null where none goes to a machine, also because it is rejected.</summary>
    public string? Target => Correction is { } correction && Act != Act.Reject ? CorrectionLabel.Target(correction) : null;

    /// <summary>Who signs.</summary>
    public string UserName { get; }

    /// <summary>True if a reason is asked for.</summary>
    public bool NeedsReason { get; }

    /// <summary>True if the password is asked for.</summary>
    public bool NeedsPassword { get; }

    /// <summary>What is to be done, in words.</summary>
    public string Title => Texts.Current[Key];

    /// <summary>Whose password is asked for.</summary>
    public string PasswordLabel => Texts.Current.With("Signing.Password", UserName);

    /// <summary>What follows, in words.</summary>
    public string Consequence => Sentence.Joined(Texts.Current[ConsequenceKey?.Invoke() ?? Key + ".Consequence"], Told?.Invoke() ?? "");

    /// <summary>Does it.</summary>
    public LongCommand Confirm { get; }

    /// <summary>Leaves everything as it is.</summary>
    public Command Leave { get; }

    /// <summary>Why.</summary>
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

    /// <summary>The password.</summary>
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

    /// <summary>What did not work; null if nothing.</summary>
    public string? Message
    {
        get => _message;
        private set => Set(ref _message, value);
    }

    /// <summary>Says that the language is another one.</summary>
    internal void Translate()
    {
        Say(nameof(Title));
        Say(nameof(Facts));
        Say(nameof(Consequence));
        Say(nameof(PasswordLabel));
        Say(nameof(Target));
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
            // Nobody is asked for a name here.
            Message = e is PeopleException { Error: PeopleError.SignInRefused } ? Texts.Current.With("Signing.WrongPassword", UserName) : Failures.Of(e, _station.Clock);
        }
        finally
        {
            Password = "";
        }
    }
}
