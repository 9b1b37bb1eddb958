using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Consecutive failed sign-ins by name, for users and unknown names alike: an unknown name is locked in the same way, so that the
/// lock does not reveal which names exist.</summary>
/// <param name="Failures">How many.</param>
/// <param name="Last">Time of the last one.</param>
internal sealed record SignInFailures(int Failures, DateTimeOffset Last)
{
    /// <summary>Names that are not users' are forgotten after this time,</summary>
    private static readonly TimeSpan Memory = TimeSpan.FromDays(1);

    /// <summary>and the oldest of them beyond this number.</summary>
    private const int MostStrangers = 1000;

    // More failures do not lock for longer.
    private const int MostRecorded = 64;

    /// <summary>Maximum number of unknown names recorded in the audit trail per hour, so that guessing cannot fill it.</summary>
    public const int MostStrangersInTrail = 20;

    /// <summary>The failures for a name.</summary>
    public static SignInFailures Of(StoreTransaction transaction, string name)
    {
        var rows = transaction.Query(
            "SELECT failures, failed_at FROM sign_in_failure WHERE name_hash = @Hash",
            r => new SignInFailures(r.GetInt32(0), StoredTime.From(r.GetInt64(1))),
            [("Hash", UserName.Hash(name))]);
        return rows is [var row] ? row : new(0, transaction.Now);
    }

    /// <summary>The failures of a user. Rows can be removed by anybody who can write the store, so the audit trail counts, too: an
    /// attempt that is compared at this moment is in the row only, and all others are in both.</summary>
    public static SignInFailures Of(StoreTransaction transaction, Person person)
    {
        var (kept, name) = (Of(transaction, person.Name), StoredText.Name(person.Name));
        var unlocked = transaction.Value<long?>(
            "SELECT max(seq) FROM audit WHERE subject = @Name AND what IN ('user-added', 'user-enabled', 'password-set')",
            [("Name", StoredText.NameOrNull((Statement?)person.Name)!.Text)]) ?? 0;
        var recorded = transaction.Query(
                "SELECT what, at FROM audit WHERE who = @name AND seq > @unlocked AND what IN ('sign-in-failed', 'locked', 'signed-in') "
                    + "ORDER BY seq DESC LIMIT @MostRecorded",
                r => (IsFailure: r.GetString(0) != "signed-in", At: StoredTime.From(r.GetInt64(1))),
                [("name", name), ("unlocked", unlocked), ("MostRecorded", MostRecorded)])
            .TakeWhile(e => e.IsFailure).ToArray();
        return recorded is not [var last, ..] ? kept
            : new(
                Math.Max(kept.Failures, recorded.Length),

                // A time to come is of a clock that was set back since: then the row has the time by the present clock.
                kept.Failures == 0 || (last.At > kept.Last && last.At <= transaction.Now) ? last.At : kept.Last);
    }

    /// <summary>Stores the failures for a name.</summary>
    public void Keep(StoreTransaction transaction, string name, bool isUser) => transaction.Execute(
        """
        INSERT INTO sign_in_failure (name_hash, is_user, failures, failed_at) VALUES (@Hash, @IsUser, @Failures, @Last)
        ON CONFLICT (name_hash) DO UPDATE SET is_user = @IsUser, failures = @Failures, failed_at = @Last
        """,
        [("Hash", UserName.Hash(name)), ("IsUser", isUser ? 1 : 0), ("Failures", Failures), ("Last", StoredTime.Of(Last))]);

    /// <summary>Clears the failures for a name.</summary>
    public static void Forget(StoreTransaction transaction, string name) =>
        transaction.Execute("DELETE FROM sign_in_failure WHERE name_hash = @Hash", [("Hash", UserName.Hash(name))]);

    /// <summary>Removes unknown names, and counts those of the last hour.</summary>
    public static long ForgetStrangers(StoreTransaction transaction)
    {
        transaction.Execute(
            "DELETE FROM sign_in_failure WHERE is_user = 0 AND failed_at < @Before",
            [("Before", StoredTime.Of(transaction.Now - Memory))]);
        transaction.Execute(
            "DELETE FROM sign_in_failure WHERE is_user = 0 AND name_hash NOT IN (SELECT name_hash FROM sign_in_failure WHERE is_user = 0 "
                + "ORDER BY failed_at DESC, name_hash LIMIT @Most)",
            [("Most", MostStrangers)]);
        return transaction.Value<long>(
            "SELECT count(*) FROM sign_in_failure WHERE is_user = 0 AND failed_at > @After",
            [("After", StoredTime.Of(transaction.Now - TimeSpan.FromHours(1)))]);
    }
}
