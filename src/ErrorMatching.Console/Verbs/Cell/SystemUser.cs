namespace ErrorMatching.Console;

/// <summary>
/// Who did what nobody signs, as the operating system knows it. Whoever may write the store's file can put another in its place without this program: a password would prove nothing, and there may be no store left to prove it against.
/// </summary>
internal static class SystemUser
{
    /// <summary>The user for the audit trail, such as <c>os:root</c> or <c>os:errormatch (sudo by anna)</c>; no user of a cell has such a name.</summary>
    /// <param name="variable">Reads an environment variable.</param>
    public static string Name(Func<string, string?> variable)
    {
        var name = Environment.UserName;
        return variable("SUDO_USER") is { Length: > 0 } before && before != name ? $"os:{name} (sudo by {before})" : "os:" + name;
    }
}
