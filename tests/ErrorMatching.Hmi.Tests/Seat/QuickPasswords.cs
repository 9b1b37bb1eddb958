using System.Reflection;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Hashes passwords with little work. A tenth of a second of a processor for each sign-in and signature is right at a station, and
/// was a seventh of what all tests of stations took.</summary>
internal static class QuickPasswords
{
    private const int Iterations = 10;

    private static readonly Type Hashes = typeof(UserBook).Assembly.GetType("ErrorMatching.Cell.PasswordHashes", throwOnError: true)!;
    private static readonly FieldInfo Field = typeof(UserBook).GetFields(BindingFlags.Instance | BindingFlags.NonPublic)
        .Single(f => f.FieldType == Hashes);

    /// <summary>Lets users be hashed and compared with little work from now on.</summary>
    public static UserBook In(UserBook users)
    {
        const BindingFlags Any = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic;
        Field.SetValue(users, Activator.CreateInstance(Hashes, Any, null, [Iterations], null));
        return users;
    }

    /// <summary>Replaces a demonstration's store by one with the same users, whose passwords are compared with little work.</summary>
    public static void In(CellSettings settings)
    {
        var file = ((SqliteSettings)settings.Store).File;
        foreach (var part in Directory.GetFiles(Path.GetDirectoryName(file)!, Path.GetFileName(file) + "*"))
        {
            File.Delete(part);
        }

        Directory.Delete(settings.KeysFolder, recursive: true);
        using var store = CellStore.Open(settings.Store, TimeProvider.System, AuditKey.Open(settings.KeysFolder));
        var users = In(new UserBook(store, TimeProvider.System));
        users.AddFirst(DemoCell.Administrator, DemoCell.Password);
        users.Add(users.SignIn(DemoCell.Administrator, DemoCell.Password), DemoCell.Setter, Role.Setter, DemoCell.Password);
        users.Add(users.SignIn(DemoCell.Administrator, DemoCell.Password), DemoCell.Operator, Role.Operator, DemoCell.Password);
    }
}
