using System.Text.RegularExpressions;

namespace ErrorMatching.Cell;

/// <summary>Names that programs at machines may have, and the names that a transfer derives from them. The whitelist is narrow enough for
/// every control, file system and protocol.</summary>
internal static partial class ProgramNames
{
    /// <summary>The rule in words, for messages.</summary>
    public const string Rule =
        "1 to 64 of A-Z a-z 0-9 . _ -, no dot or dash in front, no dot at the end, none that Windows reserves such as CON or LPT1, and "
            + "no ending that transfers use themselves (.emnew, .emold)";

    private const string NewSuffix = ".emnew";
    private const string OldSuffix = ".emold";

    /// <summary>True if the name is allowed for a program.</summary>
    public static bool Allows(string name) =>
        Allowed().IsMatch(name) && !Reserved().IsMatch(name) && !HasSuffix(name, NewSuffix) && !HasSuffix(name, OldSuffix);

    /// <summary>True for a name that Windows keeps for a device.</summary>
    internal static bool IsReserved(string name) => Reserved().IsMatch(name);

    /// <summary>True if a file in a machine's folder may be requested by this name: printable ASCII that cannot lead elsewhere and that no
    /// protocol interprets.</summary>
    internal static bool IsPlain(string name) => Plain().IsMatch(name);

    /// <summary>True if the tag is allowed in a transfer's temporary name.</summary>
    internal static bool AllowsTag(string tag) => Tag().IsMatch(tag);

    /// <summary>The name under which a program is written before it gets its own. Each attempt has a different one: what a lost connection
    /// still writes must not reach the next attempt's file.</summary>
    internal static string New(string program, string tag) => $"{program}.{tag}-{Guid.NewGuid().ToString("N")[..8]}{NewSuffix}";

    /// <summary>The old program's name while the new one is renamed, on servers that do not rename over a file.</summary>
    internal static string Old(string program) => program + OldSuffix;

    /// <summary>True if <see cref="New"/> returned this name for this program.</summary>
    internal static bool IsNewOf(string program, string name) =>
        name.StartsWith(program + ".", StringComparison.Ordinal)
        && name.EndsWith(NewSuffix, StringComparison.Ordinal)
        && name.Length > program.Length + 1 + NewSuffix.Length
        && TagAndNumber().IsMatch(name[(program.Length + 1)..^NewSuffix.Length]);

    private static bool HasSuffix(string name, string suffix) => name.EndsWith(suffix, StringComparison.OrdinalIgnoreCase);

    [GeneratedRegex(@"\A[A-Za-z0-9_]([A-Za-z0-9._-]{0,62}[A-Za-z0-9_-])?\z", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Allowed();

    [GeneratedRegex(
        @"\A(CON|PRN|AUX|NUL|COM[0-9]|LPT[0-9])(\.|\z)",
        RegexOptions.IgnoreCase | RegexOptions.ExplicitCapture | RegexOptions.CultureInvariant,
        Timeout.Infinite)]
    private static partial Regex Reserved();

    [GeneratedRegex("""\A(?![-.])[ -~-[/\\"'*?\[\]<>|:%]]{1,120}(?<![ .])\z""", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Plain();

    [GeneratedRegex(@"\A[A-Za-z0-9]{1,32}\z", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Tag();

    [GeneratedRegex(@"\A[A-Za-z0-9]{1,32}-[0-9a-f]{8}\z", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex TagAndNumber();
}
