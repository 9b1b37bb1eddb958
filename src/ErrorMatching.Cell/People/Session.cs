namespace ErrorMatching.Cell;

/// <summary>One seat at a station: who sits there, until signing out or being idle for too long. Safe for use by several threads.</summary>
/// <param name="users">The users.</param>
/// <param name="clock">The time.</param>
/// <param name="idle">How long nothing may happen before the seat counts as left.</param>
public sealed class Session(UserBook users, TimeProvider clock, TimeSpan idle)
{
    private readonly Lock _lock = new();
    private SignedIn? _who;
    private long _touched;
    private DateTimeOffset _touchedAt;

    /// <summary>Who is signed in; null if nobody is, or nothing has happened for too long.</summary>
    public SignedIn? Who
    {
        get
        {
            lock (_lock)
            {
                // By both clocks: one stands still while a computer sleeps, the other may be set back.
                if (_who is not null && (clock.GetElapsedTime(_touched) >= idle || clock.GetUtcNow() - _touchedAt >= idle))
                {
                    Leave(Recorded.Idle.With());
                }

                return _who;
            }
        }
    }

    /// <summary>Signs somebody in, in place of who sat there.</summary>
    /// <exception cref="PeopleException">As <see cref="UserBook.SignIn"/> says; nobody is signed in then.</exception>
    public SignedIn SignIn(string name, string password)
    {
        lock (_lock)
        {
            SignOut();
            _who = users.SignIn(name, password);
            Restart();
            return _who;
        }
    }

    /// <summary>Takes the password of who is signed in once more, for one act that must be signed.</summary>
    /// <exception cref="PeopleException">As <see cref="UserBook.SignIn"/> says, and with <see cref="PeopleError.NotSigned"/> if nobody is signed in.</exception>
    public SignedIn SignAgain(string password)
    {
        lock (_lock)
        {
            var who = Who ?? throw new PeopleException(PeopleError.NotSigned, "Nobody is signed in here. Sign in first.");
            var again = users.SignIn(who.Name, password);
            Restart();
            return again;
        }
    }

    /// <summary>Says that a key or button was pressed. A seat that was left stays left.</summary>
    public void Touch()
    {
        lock (_lock)
        {
            if (Who is not null)
            {
                Restart();
            }
        }
    }

    /// <summary>Signs out who is signed in, if anybody is.</summary>
    public void SignOut()
    {
        lock (_lock)
        {
            if (Who is not null)
            {
                Leave(Recorded.ByHand.With());
            }
        }
    }

    private void Restart() => (_touched, _touchedAt) = (clock.GetTimestamp(), clock.GetUtcNow());

    private void Leave(string basis)
    {
        var name = _who!.Name;
        _who = null;
        users.SignedOut(name, basis);
    }
}
