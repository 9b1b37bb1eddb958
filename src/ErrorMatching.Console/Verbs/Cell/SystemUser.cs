namespace ErrorMatching.Console;

/// <summary>The operating system's user, for acts that nobody signs. Anyone who can write the store's file can replace it without this
/// program: a password would prove nothing, and there may be no store left to check it against.</summary>
internal static class SystemUser
{
    /// <summary>The user for the audit trail, such as <c>os:root</c> or <c>os:errormatch (sudo by anna)</c>; a cell's users cannot have
    /// such a name.</summary>
    /// <param name="variable">Reads an environment variable.</param>
    public static string Name(Func<string, string?> variable)
    {
        var name = Environment.UserName;
        return variable("SUDO_USER") is { Length: > 0 } before && before != name ? $"os:{name} (sudo by {before})" : "os:" + name;
    }
}
