using System.Text.RegularExpressions;

namespace ErrorMatching.Cell;

/// <summary>Compares the name by which a control reports a program with a name that the program has. In doubt they are the same, for then
/// the file is left alone.</summary>
internal static partial class ActiveProgram
{
    /// <summary>True if both may name the same program: folders, upper and lower case, a missing ending, and leading zeros of a program's
    /// number make no difference.</summary>
    /// <param name="reported">The name that the control reports, possibly with folders.</param>
    /// <param name="name">A name of the program.</param>
    public static bool IsSame(string reported, string name)
    {
        var (one, other) = (Plain(reported), Plain(name));
        var (bareOne, bareOther) = (Bare(one), Bare(other));
        return one.Equals(other, StringComparison.OrdinalIgnoreCase)
            || ((bareOne.Length == one.Length || bareOther.Length == other.Length) && AreSame(bareOne, bareOther));
    }

    /// <summary>False if a name says too little to tell programs apart: nothing is left of it without its folders, it was shortened by the
    /// file system (<c>LONGNA~1.NC</c>), or it was not decoded.</summary>
    public static bool CanBeCompared(string reported) =>
        Plain(reported) is { Length: > 0 } name && !Shortened().IsMatch(name) && !name.Any(c => char.IsControl(c) || c == '\uFFFD');

    /// <summary>The number of a program without leading zeros, if a name is one: O0100, 100, O100.NC, <c>O100 (KEY)</c>. Empty if it is
    /// none.</summary>
    public static string NumberOf(string name) => Number(Bare(Plain(name))) is { Length: > 0 } number
        ? number
        : Commented().Match(name) is { Success: true } m ? m.Groups["number"].Value : "";

    /// <summary>The last part of a name without its ending.</summary>
    public static string WithoutEnding(string name) => Bare(Plain(name));

    private static bool AreSame(string one, string other) =>
        one.Equals(other, StringComparison.OrdinalIgnoreCase) || (Number(one) is { Length: > 0 } number && number == Number(other));

    // A control may report program O0100 as 100.
    private static string Number(string name) => NumberAlone().Match(name) is { Success: true } m ? m.Groups["number"].Value : "";

    // The last part of a path. Some controls store P100.MPF as _N_P100_MPF.
    private static string Plain(string name)
    {
        var last = name.Trim().Trim('"').Split(['/', '\\', ':'])[^1].Trim();
        return Internal().Match(last) is { Success: true } m ? $"{m.Groups["name"].Value}.{m.Groups["ending"].Value}" : last;
    }

    private static string Bare(string name) => name.LastIndexOf('.') is > 0 and var dot ? name[..dot] : name;

    [GeneratedRegex(@"\A[oO]?0*(?<number>[0-9]+)\z", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex NumberAlone();

    // Some controls report the comment behind the number, too.
    [GeneratedRegex(@"(\A|[/\\:])\s*[oO]?0*(?<number>[0-9]+)\s*[(\s]", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Commented();

    [GeneratedRegex(@"~[0-9]", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Shortened();

    [GeneratedRegex(@"\A_[nN]_(?<name>.+)_(?<ending>[A-Za-z]{3})\z", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Internal();
}
