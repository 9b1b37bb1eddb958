namespace ErrorMatching.Cell;

/// <summary>Passwords of machines, encrypted in the store with keys that are not in it.</summary>
/// <param name="store">The store that holds them.</param>
/// <param name="keysFolder">The key folder; created when the first password is set.</param>
public sealed class MachineSecrets(CellStore store, string keysFolder)
{
    /// <summary>The longest password, in UTF-16 units.</summary>
    private const int MostCharacters = 1024;

    private readonly Lazy<KeyRing> _keys = new(() => new KeyRing(keysFolder));

    /// <summary>Sets the password of a machine. The caller must check <see cref="Act.ManageMachines"/>.</summary>
    /// <param name="machine">The machine's name. The password is bound to it: moved to another machine's row, it cannot be
    /// decrypted.</param>
    /// <param name="secret">The password: 1 to 1024 characters, none of them a control character.</param>
    /// <param name="by">The user who sets it, for the audit trail. The trail does not contain the password.</param>
    /// <exception cref="PeopleException">With <see cref="PeopleError.BadSecret"/> or <see cref="PeopleError.KeysUnusable"/>.</exception>
    public void Set(string machine, string secret, string by)
    {
        if (secret.Length is 0 or > MostCharacters || secret.Any(char.IsControl))
        {
            throw new PeopleException(
                PeopleError.BadSecret,
                $"The password of a machine has 1 to {MostCharacters} characters, none of them a control character such as a tab.");
        }

        var bytes = _keys.Value.Protect(PurposesOf(machine), secret);
        store.Write(t =>
        {
            t.Execute(
                "INSERT INTO machine_secret (machine, bytes) VALUES (@Machine, @Bytes) ON CONFLICT (machine) DO UPDATE SET bytes = @Bytes",
                [("Machine", machine), ("Bytes", bytes)]);
            t.Audit(by, "secret-set", machine, "");
            return bytes;
        });
    }

    /// <summary>Removes the password of a machine.</summary>
    /// <returns>False if there was none.</returns>
    public bool Remove(string machine, string by) => store.Write(t =>
    {
        var any = t.Execute("DELETE FROM machine_secret WHERE machine = @Machine", [("Machine", machine)]) > 0;
        if (any)
        {
            t.Audit(by, "secret-removed", machine, "");
        }

        return any;
    });

    /// <summary>The password of a machine; null if none was set.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.SecretUnreadable"/> or
    /// <see cref="PeopleError.KeysUnusable"/>.</exception>
    public string? Get(string machine) =>
        store.Read(
            "SELECT bytes FROM machine_secret WHERE machine = @Machine",
            r => (byte[])r.GetValue(0),
            [("Machine", machine)]) is [var bytes]
            ? _keys.Value.Unprotect(PurposesOf(machine), bytes, $"The password of machine {machine}")
            : null;

    private static string[] PurposesOf(string machine) => ["password of a machine", machine];
}
