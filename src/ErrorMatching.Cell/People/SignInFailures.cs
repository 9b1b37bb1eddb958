namespace ErrorMatching.Cell;

/// <summary>Failed sign-ins in a row by name, whether it is a user's or not: a name that is none is locked like any other, so that nobody learns which are.</summary>
/// <param name="Failures">How many.</param>
/// <param name="Last">When the last one was.</param>
internal sealed record SignInFailures(int Failures, DateTimeOffset Last)
{
    /// <summary>Names that are no user's are forgotten after this time,</summary>
    private static readonly TimeSpan Memory = TimeSpan.FromDays(1);

    /// <summary>and the oldest of them when there are more.</summary>
    private const int MostStrangers = 1000;

    /// <summary>So many names that are no user's get into the audit trail in an hour; it must not be filled by guessing.</summary>
    public const int MostStrangersInTrail = 20;

    /// <summary>Those of a name.</summary>
    public static SignInFailures Of(StoreTransaction transaction, string name)
    {
        var rows = transaction.Query(
            "SELECT failures, failed_at FROM sign_in_failure WHERE name_hash = @Hash", r => new SignInFailures(r.GetInt32(0), StoredTime.From(r.GetInt64(1))), new { Hash = UserName.Hash(name) });
        return rows is [var row] ? row : new(0, transaction.Now);
    }

    /// <summary>Keeps those of a name.</summary>
    public void Keep(StoreTransaction transaction, string name, bool isUser) => transaction.Execute(
        """
        INSERT INTO sign_in_failure (name_hash, is_user, failures, failed_at) VALUES (@Hash, @IsUser, @Failures, @Last)
        ON CONFLICT (name_hash) DO UPDATE SET is_user = @IsUser, failures = @Failures, failed_at = @Last
        """,
        new { Hash = UserName.Hash(name), IsUser = isUser ? 1 : 0, Failures, Last = StoredTime.Of(Last) });

    /// <summary>Forgets those of a name.</summary>
    public static void Forget(StoreTransaction transaction, string name) =>
        transaction.Execute("DELETE FROM sign_in_failure WHERE name_hash = @Hash", new { Hash = UserName.Hash(name) });

    /// <summary>Forgets names that are no user's, and counts those of the last hour.</summary>
    public static long ForgetStrangers(StoreTransaction transaction)
    {
        transaction.Execute("DELETE FROM sign_in_failure WHERE is_user = 0 AND failed_at < @Before", new { Before = StoredTime.Of(transaction.Now - Memory) });
        transaction.Execute(
            "DELETE FROM sign_in_failure WHERE is_user = 0 AND name_hash NOT IN (SELECT name_hash FROM sign_in_failure WHERE is_user = 0 ORDER BY failed_at DESC, name_hash LIMIT @Most)",
            new { Most = MostStrangers });
        return transaction.Value<long>("SELECT count(*) FROM sign_in_failure WHERE is_user = 0 AND failed_at > @After", new { After = StoredTime.Of(transaction.Now - TimeSpan.FromHours(1)) });
    }
}
