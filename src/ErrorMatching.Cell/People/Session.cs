using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>One user's session at a station, until sign-out or a period of inactivity. Thread-safe.</summary>
/// <param name="users">The users.</param>
/// <param name="clock">The clock.</param>
/// <param name="idle">The period of inactivity after which the session ends.</param>
public sealed class Session(UserBook users, TimeProvider clock, TimeSpan idle)
{
    private readonly Lock _lock = new();
    private SignedIn? _who;
    private long _touched;
    private DateTimeOffset _touchedAt;

    /// <summary>The signed-in user; null if no one is signed in or the session has timed out.</summary>
    public SignedIn? Who
    {
        get
        {
            lock (_lock)
            {
                // By both clocks: one stops while a computer sleeps, the other may be set back.
                if (_who is not null && (clock.GetElapsedTime(_touched) >= idle || clock.GetUtcNow() - _touchedAt >= idle))
                {
                    Leave(Recorded.Idle.With());
                }

                return _who;
            }
        }
    }

    /// <summary>Signs a user in, in place of the current one.</summary>
    /// <exception cref="PeopleException">As for <see cref="UserBook.SignIn"/>; then no one is signed in.</exception>
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

    /// <summary>Takes the signed-in user's password again, for one act that must be signed.</summary>
    /// <exception cref="PeopleException">As for <see cref="UserBook.SignIn"/>, and with <see cref="PeopleError.NotSigned"/> if no one is
    /// signed in.</exception>
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

    /// <summary>Reports a key press or click. A session that has timed out stays ended.</summary>
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

    /// <summary>Signs out the current user, if any.</summary>
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

    private void Leave(Statement basis)
    {
        var name = _who!.Name;
        _who = null;
        users.SignedOut(name, basis);
    }
}
