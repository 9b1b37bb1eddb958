using System.Globalization;
using System.Text.RegularExpressions;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Reads what earlier versions recorded in English, as far as the replay of a trail needs it. People see these sentences as they
/// were written.</summary>
internal static partial class EnglishRecord
{
    /// <summary>The correction that an entry is about, and its file or program; null if it is about none.</summary>
    public static (long Id, string? File, string? Program)? CorrectionOf(Statement subject) =>
        subject.Words is { } words && Subject().Match(words) is { Success: true } found
        && long.TryParse(found.Groups["id"].ValueSpan, NumberStyles.None, CultureInfo.InvariantCulture, out var id)
            ? (id, Value(found, "file"), Value(found, "program"))
            : null;

    /// <summary>True if a basis names the policy.</summary>
    public static bool IsPolicy(Statement basis) => basis.Words is { } words && Policy().IsMatch(words);

    /// <summary>The word of the role that a basis gives to a user; null if it gives none.</summary>
    public static string? RoleOf(Statement basis) =>
        basis.Words is { } words && Role().Match(words) is { Success: true } found ? Value(found, "role") : null;

    /// <summary>The files of a saved job, the job itself last.</summary>
    public static IReadOnlyList<(string Name, string Sha256)> JobFilesOf(Statement basis) =>
        basis.Words is not { } words ? []
        : [
            .. JobFile().Matches(InPlace().Replace(words, "", 1)).Select(m => (m.Groups["name"].Value, m.Groups["hash"].Value))];

    private static string? Value(Match found, string name) => found.Groups[name] is { Success: true, Value: var value } ? value : null;

    [GeneratedRegex(
        @"^correction (?<id>[0-9]+)( file (?<file>.+)| program (?<program>.+))?\z",
        RegexOptions.ExplicitCapture | RegexOptions.Singleline | RegexOptions.CultureInvariant,
        Timeout.Infinite)]
    private static partial Regex Subject();

    [GeneratedRegex(
        @"^policy: automatic( within .+ mm)?\z",
        RegexOptions.ExplicitCapture | RegexOptions.Singleline | RegexOptions.CultureInvariant,
        Timeout.Infinite)]
    private static partial Regex Policy();

    [GeneratedRegex(
        @"^(as|to) (?<role>.+)\z",
        RegexOptions.ExplicitCapture | RegexOptions.Singleline | RegexOptions.CultureInvariant,
        Timeout.Infinite)]
    private static partial Regex Role();

    [GeneratedRegex(
        "(^|, )(?<name>.+?) (?<hash>[0-9a-f]{64})", RegexOptions.ExplicitCapture | RegexOptions.CultureInvariant, Timeout.Infinite)]
    private static partial Regex JobFile();

    [GeneratedRegex(
        @", in place of the job .+\z",
        RegexOptions.ExplicitCapture | RegexOptions.Singleline | RegexOptions.CultureInvariant,
        Timeout.Infinite)]
    private static partial Regex InPlace();
}
