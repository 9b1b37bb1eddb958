using System.Reflection;
using System.Text.RegularExpressions;
using ErrorMatching.Cell;
using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Every code that a library can give the station to show has words in both languages.</summary>
public sealed partial class CodeTextTests
{
    private const string Sentence = "Something is so.";

    // Written like codes, and shown to nobody as the reason of anything: names in files, on the wire and of dialects.
    private static readonly string[] NoCodes =
    [
        "probing-log", "errormatch-machine", "errormatch-cell", "along-axis", "in-plane", "toward-plus", "stricter-limits",
        "conditional-stop", "delta-nc300", "siemens-840d",
        "heidenhain-klartext",
        "fanuc-p98xx",
        "answers-again", "held-again", "no-answer", "alarm-acknowledged", "alarm-shelved", "alarm-unshelved",
    ];

    [Fact]
    public Task Every_code_has_words_in_both_languages_and_none_is_shown_itself() => Drawing.Needed().RunAsync(() =>
    {
        var codes = Declared().Concat(Documented()).Distinct(StringComparer.Ordinal).Order(StringComparer.Ordinal).ToArray();
        Assert.True(codes.Length > 120, "Codes are not found any more.");
        var wordless = new List<string>();
        try
        {
            foreach (var language in Enum.GetValues<Language>())
            {
                Texts.Current.Language = language;
                wordless.AddRange(codes.Where(c => !HasWords(c, language)).Select(c => $"{c} ({language})"));
            }
        }
        finally
        {
            Texts.Current.Language = Language.English;
        }

        Assert.True(wordless.Count == 0, "Add Code.CODE or Meaning.CODE to the texts of both languages: " + string.Join(", ", wordless));
    });

    [Fact]
    public Task What_nobody_has_words_for_is_quoted_and_a_part_of_the_cell_has_its_name_in_Chinese() => Drawing.Needed().RunAsync(() =>
    {
        Assert.Equal(Sentence, CodeText.Of("not-heard-of", Sentence));
        Assert.Equal(("slot vmc1/A", "heartbeat"), (CodeText.Where(CellTrouble.OfSlot("vmc1", "A")), CodeText.Where("signs of life")));
        Texts.Current.Language = Language.TraditionalChinese;
        try
        {
            Assert.Equal("操作站沒有此問題的說明文字。（原文：Something is so.）", CodeText.Of("not-heard-of", Sentence));
            Assert.Equal("磁碟已滿。（原文：Something is so.）", CodeText.Of(CellCodes.Of(StoreError.Full), Sentence));
            Assert.Equal("機台不允許。", CodeText.Of(CellCodes.Of(TransportError.Denied), null));
            Assert.Equal(("程式槽 vmc1/A", "執行訊號"), (CodeText.Where(CellTrouble.OfSlot("vmc1", "A")), CodeText.Where("signs of life")));
            Assert.Equal("量測儀 cmm1", CodeText.Where(CellTrouble.OfGauge("cmm1")));
        }
        finally
        {
            Texts.Current.Language = Language.English;
        }
    });

    // A field of the set-up, a decision, a saved job and a warning have texts of their own for theirs.
    private static bool HasWords(string code, Language language) =>
        new[] { "Problem.", "Decision.", "JobEdit.", "Warning." }.Any(p => Texts.Of(language).ContainsKey(p + code))
        || (CodeText.Of(code, null) is var text && text != Texts.Current["Meaning.Other"] && !Raw().IsMatch(text)
            && (language == Language.English || IsChinese(text)));

    private static bool IsChinese(string text) => text.Any(c => c is >= '\u4e00' and <= '\u9fff');

    // What is declared: all string constants written like codes, and the enumerations of what can go wrong.
    private static IEnumerable<string> Declared() =>
    [
        .. new[] { typeof(CellStore), typeof(OutputException), typeof(Matcher), typeof(Compensator), typeof(NcProgram) }
            .Append(typeof(MeasurementError))
            .SelectMany(t => t.Assembly.GetTypes())
            .SelectMany(t => t.GetFields(BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Static | BindingFlags.DeclaredOnly)
                .Where(f => f.IsLiteral && f.FieldType == typeof(string))
                .Select(f => (string)f.GetRawConstantValue()!)
                .Where(c => Raw().IsMatch(c) || (t.Name.EndsWith("Codes", StringComparison.Ordinal) && c.Length > 0)))
            .Except(NoCodes)
            .Where(c => !c.Contains(' ', StringComparison.Ordinal))
            .Except([JobEdits.Edited, JobEdits.EditFailed, JobEdits.Found, JobEdits.Prepared]),
        .. Enum.GetValues<StoreError>().Select(CellCodes.Of),
        .. Enum.GetValues<TransportError>().Select(CellCodes.Of),
        .. Enum.GetValues<GeometryError>().Select(e => InputRefusals.Of(new GeometryException(e, ""), "").Code),
    ];

    // What has no constant stands in the page of refusals.
    private static IEnumerable<string> Documented() =>
        File.ReadLines(Repository.PathTo("docs", "refusals.md"))
            .Select(l => Row().Match(l)).Where(m => m.Success).Select(m => m.Groups["code"].Value);

    [GeneratedRegex("^[a-z]+(-[a-z0-9]+)+$", RegexOptions.ExplicitCapture | RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Raw();

    [GeneratedRegex(@"^\| `(?<code>[a-z]+(-[a-z0-9]+)*)` \|", RegexOptions.ExplicitCapture | RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Row();
}
