namespace ErrorMatching.Cell.Tests;

/// <summary>A store with users in a folder of its own. Hashes are cheap here but where the test is about them.</summary>
public abstract class PeopleTest : IDisposable
{
    protected const string Right = "correct horse battery";
    protected const string Other = "staple of the ox";
    private readonly string _folder = Directory.CreateTempSubdirectory("errormatch-people-").FullName;

    private protected PeopleTest()
    {
        Key = AuditKey.Open(Keys);
        Store = CellStore.Open(new SqliteSettings(PathOf("cell.db")), Clock, Key);
        Users = new UserBook(Store, Clock, new PasswordHashes(10));
    }

    protected string Keys => PathOf("keys");

    private protected byte[] Key { get; }

    private protected CellStore Store { get; }

    private protected WorkClock Clock { get; } = new();

    private protected UserBook Users { get; }

    private protected IReadOnlyList<string> Trail => [
        .. Store.AuditEntries(0, 10_000).Select(
            e => $"{e.Who} {e.What} {Stated.As(e.Subject)} {Stated.As(e.Basis)}".Replace("  ", " ", StringComparison.Ordinal).Trim())];

    public void Dispose()
    {
        Store.Dispose();
        Directory.Delete(_folder, recursive: true);
        GC.SuppressFinalize(this);
    }

    protected string PathOf(string name) => Path.Combine(_folder, name);

    /// <summary>Anna, the first administrator, signs.</summary>
    private protected SignedIn Anna()
    {
        if (Users.IsEmpty)
        {
            Users.AddFirst("Anna", Right);
        }

        return Users.SignIn("Anna", Right);
    }

    private protected static PeopleException Refused(PeopleError error, Action act)
    {
        var refusal = Assert.Throws<PeopleException>(act);
        Assert.Equal(error, refusal.Error);
        Assert.EndsWith(".", refusal.Message, StringComparison.Ordinal);
        return refusal;
    }
}
