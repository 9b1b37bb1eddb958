using System.Globalization;
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

    // This process: two on one computer, or one that was started again, must not be mistaken for each other.
    private static readonly string Owner = Guid.NewGuid().ToString("N")[..8];
    private static uint _attempts;

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

    /// <summary>The name under which a program is written before it gets its own. It names the process and its attempt, and no two attempts
    /// have the same: what a lost connection or a frozen process still does must not reach the file of another attempt.</summary>
    internal static string New(string program, string tag) => string.Create(
        CultureInfo.InvariantCulture, $"{program}.{tag}-{Owner}-{Interlocked.Increment(ref _attempts)}{NewSuffix}");

    /// <summary>The name for the program that an attempt replaces, until it is compared.</summary>
    /// <param name="written">The attempt's name of the new program, from <see cref="New"/>.</param>
    internal static string Old(string written) => written[..^NewSuffix.Length] + OldSuffix;

    /// <summary>True if <see cref="New"/> returned this name for this program, here or in another process.</summary>
    internal static bool IsNewOf(string program, string name) => IsOf(program, name, NewSuffix);

    /// <summary>True if <see cref="Old"/> returned this name for this program, here or in another process. Earlier versions had the same
    /// name for all attempts.</summary>
    internal static bool IsOldOf(string program, string name) => name == program + OldSuffix || IsOf(program, name, OldSuffix);

    private static bool IsOf(string program, string name, string suffix) =>
        name.StartsWith(program + ".", StringComparison.Ordinal)
        && name.EndsWith(suffix, StringComparison.Ordinal)
        && name.Length > program.Length + 1 + suffix.Length
        && Attempt().IsMatch(name[(program.Length + 1)..^suffix.Length]);

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

    // The attempt's number is missing in names of earlier versions.
    [GeneratedRegex(@"\A[A-Za-z0-9]{1,32}-[0-9a-f]{8}(-[0-9]{1,10})?\z", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Attempt();
}
