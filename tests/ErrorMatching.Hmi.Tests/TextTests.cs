using System.Text.RegularExpressions;
using ErrorMatching.Cell;
using ErrorMatching.Mating;
using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

public sealed partial class TextTests
{
    [Fact]
    public void Both_languages_have_the_same_keys() =>
        Assert.Equal(
            Texts.Of(Language.English).Keys.Order(StringComparer.Ordinal),
            Texts.Of(Language.TraditionalChinese).Keys.Order(StringComparer.Ordinal));

    [Fact]
    public void No_text_is_empty() =>
        Assert.All(Enum.GetValues<Language>().SelectMany(l => Texts.Of(l)), t => Assert.False(string.IsNullOrWhiteSpace(t.Value), t.Key));

    [Fact]
    public void Both_languages_have_the_same_places_for_values() => Assert.All(
        Texts.Of(Language.English),
        t => Assert.Equal(Places(t.Value), Places(Texts.Of(Language.TraditionalChinese)[t.Key])));

    [Fact]
    public void What_is_not_a_name_or_a_format_is_translated() => Assert.All(
        Texts.Of(Language.TraditionalChinese).Where(
            t => t.Key is not (
                "Format.Time"
                    or "Format.DayExample"
                    or "Shell.OtherLanguage"
                    or "Banner.Trouble"
                    or "Recorded.Between"
                    or "Recorded.at-place"
                    or "Recorded.job-file"
                    or "Recorded.job-files"
                    or "List.Between"
                    or "System.LabelsOf"
                    or "Detail.X"
                    or "Detail.Y"
                    or "Keyboard.Letters"
                    or "Keyboard.Signs"
                    or "Keyboard.Numbers")),
        t => Assert.True(t.Value.Any(c => c is >= '\u4e00' and <= '\u9fff'), t.Key));

    [Fact]
    public void A_unit_stands_in_parentheses_behind_its_name_in_Chinese() => Assert.All(
        Texts.Of(Language.TraditionalChinese),
        t => Assert.DoesNotMatch(UnitBehindComma(), t.Value));

    [Fact]
    public void A_number_and_its_unit_stay_in_one_line()
    {
        Assert.All(Enum.GetValues<Language>().SelectMany(l => Texts.Of(l)), t => Assert.DoesNotMatch(PartedUnit(), t.Value));
        Assert.Equal("Largest displacement 0.1\u00a0mm", Texts.Current.With("Head.Largest", "0.1"));
    }

    [Fact]
    public void One_thing_has_one_word_in_Chinese_and_one_word_is_one_thing()
    {
        var texts = Texts.Of(Language.TraditionalChinese);
        Assert.DoesNotContain(texts, t => t.Value.Contains("量測點", StringComparison.Ordinal));
        Assert.NotEqual(texts["System.From"], texts["Detail.Basis"]);

        // What a program is displaced by; a job, which is no work order and no workpiece;
        // a screen and who leads there, beside the proof of a program and the seals of the trail.
        Assert.DoesNotContain(texts, t => t.Value.Contains("移動量", StringComparison.Ordinal));
        Assert.DoesNotContain(texts, t => t.Value.Contains("工作", StringComparison.Ordinal));
        Assert.Equal(
            ["Next.Measure", "Screen.verification"], texts.Where(t => t.Value.Contains("驗證", StringComparison.Ordinal)).Select(t => t.Key));

        // Two pieces are compared; only one of them is the part.
        Assert.DoesNotContain("工件之間", texts["Detail.GapBefore"], StringComparison.Ordinal);
    }

    [Fact]
    public void One_thing_has_one_word_in_English()
    {
        var texts = Texts.Of(Language.English);
        Assert.DoesNotContain(texts, t => t.Value.Contains("largest move", StringComparison.OrdinalIgnoreCase));
        Assert.Single(
            texts.Where(t => t.Key is "Signing.Leave" or "Chooser.Leave" or "Connection.Cancel")
                .Select(t => t.Value)
                .Distinct(StringComparer.Ordinal));
        Assert.Equal((texts["System.Lower"], texts["System.Upper"]), (texts["Verify.Low"], texts["Verify.High"]));
    }

    [Theory]
    [InlineData("位移。一點。", "位移。", "一點。")]
    [InlineData("Displaced. One point.", "Displaced.", "", "One point.")]
    [InlineData("位移。One point. 一點。", "位移。", "One point.", "一點。")]
    [InlineData("")]
    public void Sentences_have_a_space_between_them_where_their_full_stop_has_none(string joined, params string[] sentences) =>
        Assert.Equal(joined, Sentence.Joined(sentences));

    [Fact]
    public void Every_value_that_is_shown_by_name_has_a_text()
    {
        string[] keys =
        [
            .. Names<Role>(), .. Names<TouchSize>(), .. Names<CorrectionState>(), .. Names<PeopleError>(), .. Names<StoreError>(),
            .. Names<TransportError>(), .. Names<AuditFaultKind>(),
            .. Screens.All.Select(s => "Screen." + s.Key),
            .. Enum.GetNames<FileChoiceKind>().Select(k => "Chooser." + k),
            .. new[] { Act.Approve, Act.Reject, Act.Release, Act.Revert }.SelectMany(a => new[] { "Act." + a, $"Act.{a}.Consequence" }),
            .. typeof(DecisionException).GetFields().Where(f => f.IsLiteral).Select(f => "Decision." + f.GetRawConstantValue()),
            .. typeof(NcRefusalCodes).GetFields().Concat(typeof(NcInputCodes).GetFields())
                .Select(f => "Meaning." + f.GetRawConstantValue()),
            .. Names<AlarmPriority>(), .. Names<AlarmFilter>(), "Act.Acknowledge", "Act.Shelve",
            .. AlarmBook.Words.Select(w => "Audited." + w),
            .. Enum.GetNames<CorrectionState>().Select(s => "Audited." + s.ToLowerInvariant()),
            .. Recorded.All.Select(f => "Recorded." + f.Name), .. WarningForms.All.Select(f => "Warning." + f.Name),
            .. RefusalForms.All.Select(f => "Refusal." + f.Name),
            .. Enum.GetNames<Role>().Select(r => "RecordedWord." + r.ToLowerInvariant()),
        ];
        Assert.All(keys, k => Assert.True(Texts.Of(Language.English).ContainsKey(k), k));
    }

    [Fact]
    public void Every_key_that_the_sources_name_has_a_text()
    {
        var named = Directory.EnumerateFiles(Repository.PathTo("src", "ErrorMatching.Hmi"), "*", SearchOption.AllDirectories)
            .Where(f => f.EndsWith(".axaml", StringComparison.Ordinal) || f.EndsWith(".cs", StringComparison.Ordinal))
            .SelectMany(f => Key().Matches(File.ReadAllText(f)).Select(m => m.Groups["key"].Value))
            .ToHashSet(StringComparer.Ordinal);
        Assert.True(named.Count > 80, "Keys are not found any more.");
        Assert.All(named, k => Assert.True(Texts.Of(Language.English).ContainsKey(k), k));
    }

    [Fact]
    public void No_words_stand_in_the_views_themselves() => Assert.All(
        Directory.EnumerateFiles(Repository.PathTo("src", "ErrorMatching.Hmi"), "*.axaml", SearchOption.AllDirectories),
        f => Assert.DoesNotContain(
            Literal().Matches(File.ReadAllText(f)).Select(m => m.Groups["words"].Value), w => w != "mm" && w.Any(char.IsLetter)));

    [Theory]
    [InlineData(Language.English, "2026-03-01 07:05:09")]
    [InlineData(Language.TraditionalChinese, "2026/03/01 07:05:09")]
    public Task A_time_is_shown_by_the_custom_of_the_language(Language language, string shown) => Drawing.Needed().RunAsync(() =>
    {
        Texts.Current.Language = language;
        Assert.Equal(shown, Shown.Time(new(2026, 3, 1, 8, 5, 9, TimeSpan.FromHours(1)), new SeatClock()));
        Texts.Current.Language = Language.English;
    });

    [Theory]
    [InlineData(0.12344, "+0.1234")]
    [InlineData(-0.12346, "−0.1235")]
    [InlineData(-0.00001, "0.0000")]
    [InlineData(0.0, "0.0000")]
    [InlineData(null, "–")]
    public void A_deviation_has_its_sign_and_four_decimals(double? mm, string shown) => Assert.Equal(shown, Shown.SignedMm(mm));

    private static IEnumerable<string> Names<T>()
        where T : struct, Enum => Enum.GetNames<T>().Select(n => $"{typeof(T).Name}.{n}");

    private static IEnumerable<string> Places(string text) => Place().Matches(text).Select(m => m.Value).Order(StringComparer.Ordinal);

    [GeneratedRegex(@"[,，] ?(mm|µm|s|°)(/s)?$|\((mm|µm|°)\)", RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex UnitBehindComma();

    [GeneratedRegex(
        """(Text|Content|Header|PlaceholderText|Title|ToolTip\.Tip|AutomationProperties\.Name|AutomationProperties\.HelpText)="(?<words>[^"{][^"]*)""",
        RegexOptions.ExplicitCapture,
        1000)]
    private static partial Regex Literal();

    [GeneratedRegex(@"\{\d\}", RegexOptions.None, 1000)]
    private static partial Regex Place();

    [GeneratedRegex(@"[\d}] (mm|µm)\b", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex PartedUnit();

    [GeneratedRegex(
        """(\{l:Text |[Tt]exts(\.Current)?\[|(\.With|texts\.With|Texts\.Current\.With)\()"?(?<key>[A-Za-z]+\.[A-Za-z.\-]*[A-Za-z])["}]""",
        RegexOptions.None | RegexOptions.ExplicitCapture,
        1000)]
    private static partial Regex Key();
}
