using System.Text;
using ErrorMatching.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.Nc.Tests;

/// <summary>The dialects that come with the library are data of the same form as a shop's own.</summary>
public sealed class BuiltInDialectTests
{
    // No code of a built-in dialect has these meanings; a shop's file may use them all.
    private static readonly NcMeaning[] Unused = [];

    private static readonly Dictionary<string, int> Meanings = KebabNames.Of(typeof(NcMeaning));

    private static readonly string[] Files = [.. NcDialects.Bases];

    public static TheoryData<string> Names => [.. NcDialects.Names];

    public static TheoryData<string> FileNames => [.. Files];

    [Fact]
    public void The_built_in_ones_have_names_in_order()
    {
        Assert.Equal(
            [
                "generic", "fanuc", "delta-nc300", "haas", "mazak-eia", "mitsubishi-m80", "okuma-osp", "siemens-840d", "linuxcnc", "grbl",
                "heidenhain-klartext",
            ],
            NcDialects.Names);
        Assert.Equal(NcDialects.Names, NcDialects.All.Select(d => d.Name));
        Assert.All(NcDialects.All, d => Assert.Empty(d.Files));
    }

    [Theory]
    [MemberData(nameof(FileNames))]
    public void Each_file_keeps_the_schema(string name)
    {
        var schema = JsonSchema.Parse(Encoding.UTF8.GetBytes(NcDialects.Schema), "dialect.schema.json");
        var document = JsonInput.Read(File.ReadAllBytes(PathTo(name)), name);
        Assert.Empty(schema.Check(document));
        Assert.Equal(name, document["name"].Text);
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Each_fact_has_a_sentence_and_a_source(string name) => Assert.All(NcDialects.Named(name).Facts, f =>
    {
        Assert.EndsWith(".", f.Statement, StringComparison.Ordinal);
        Assert.True(f.Source is "assumed" or "measured with rs274" || f.Source.Contains(' ', StringComparison.Ordinal), f.ToString());
        Assert.Contains(f.Dialect, NcDialects.Bases);
        Assert.Equal(
            f.Topic is DialectTopic.Flow or DialectTopic.MachineProgram or DialectTopic.Note,
            f.Meaning.Length == 0 && f.Subject != "turnsLetter");
    });

    [Theory]
    [MemberData(nameof(Names))]
    public void Each_code_letter_and_function_of_the_tables_is_on_the_page_with_its_meaning(string name)
    {
        var dialect = NcDialects.Named(name);
        var page = dialect.Facts.Where(f => f.Topic is DialectTopic.Code)
            .SelectMany(f => f.Subject.Split(' ').SelectMany(TenthsOf).Select(t => (Tenths: t, Meaning: f.Meaning.Split(" (")[0])))
            .ToLookup(p => p.Tenths, p => p.Meaning);
        for (var tenths = 0; tenths < 10_000; tenths++)
        {
            Assert.Equal(dialect.MeaningOf(tenths) != NcMeaning.Unknown, page[tenths].Any(m => m != "unknown"));
            Assert.All(page[tenths], m => Assert.Equal(dialect.MeaningOf(tenths), (NcMeaning)Meanings[m]));
        }

        foreach (var fact in dialect.Facts.Where(f => f.Topic is DialectTopic.Letter))
        {
            Assert.All(
                fact.Subject.Split(' '),
                l => Assert.Equal(
                    (LetterRole)KebabNames.Of(typeof(LetterRole))[fact.Meaning],
                    l.Length == 1 ? dialect.RoleOf((byte)l[0]) : dialect.RoleOf(Encoding.ASCII.GetBytes(l))));
        }
    }

    [Fact]
    public void Schema_knows_each_meaning_and_role_by_its_name()
    {
        var schema = NcDialects.Schema;
        Assert.All(
            new[] { typeof(NcMeaning), typeof(LetterRole), typeof(FunctionRole), typeof(NcSyntax) }.SelectMany(t => KebabNames.Of(t).Keys),
            n => Assert.Contains($"\"{n}\"", schema, StringComparison.Ordinal));
        Assert.Equal(
            ["plane-xy", "arc-counter-clockwise", "retract-to-r"],
            new[] { "PlaneXY", "ArcCounterClockwise", "RetractToR" }.Select(KebabNames.Of));
    }

    [Fact]
    public void Each_meaning_is_used_by_some_built_in_dialect_or_unused_on_purpose()
    {
        var used = NcDialects.All.SelectMany(d => d.Facts)
            .Where(f => f.Topic == DialectTopic.Code)
            .Select(f => f.Meaning.Split(" (")[0])
            .ToHashSet(StringComparer.Ordinal);
        Assert.Equal(Unused, Enum.GetValues<NcMeaning>().Where(m => !used.Contains(KebabNames.Of(m.ToString()))));
    }

    [Fact]
    public void Each_file_is_in_the_library() => Assert.Equal(
        Files.Append("dialect.schema").Select(f => $"ErrorMatching.Nc.Dialects.{f}.json").Order(StringComparer.Ordinal),
        typeof(NcDialect).Assembly.GetManifestResourceNames()
            .Where(n => n.StartsWith("ErrorMatching.Nc.Dialects.", StringComparison.Ordinal))
            .Order(StringComparer.Ordinal));

    [Theory]
    [InlineData("generic", "G20", NcMeaning.Inch)]
    [InlineData("fanuc", "G43.4", NcMeaning.OpaqueTransform)]
    [InlineData("fanuc", "G107", NcMeaning.OpaqueTransform)]
    [InlineData("fanuc", "G77", NcMeaning.Unknown)]
    [InlineData("fanuc", "G76", NcMeaning.FineBoreCycle)]
    [InlineData("fanuc", "G87", NcMeaning.BackBoreCycle)]
    [InlineData("generic", "G87", NcMeaning.OpaqueCycle)]
    [InlineData("linuxcnc", "G76", NcMeaning.Unsure)]
    [InlineData("linuxcnc", "G71", NcMeaning.Unsure)]
    [InlineData("haas", "G71", NcMeaning.BoltArc)]
    [InlineData("haas", "G72", NcMeaning.BoltLine)]
    [InlineData("haas", "G5.1", NcMeaning.Unknown)]
    [InlineData("grbl", "G41", NcMeaning.Unknown)]
    [InlineData("mazak-eia", "G81", NcMeaning.DrillCycle)]
    [InlineData("mazak-eia", "G72.1", NcMeaning.OpaqueLevelCycle)]
    [InlineData("mitsubishi-m80", "G12", NcMeaning.OpaqueMotion)]
    [InlineData("okuma-osp", "G56", NcMeaning.LengthOffset)]
    [InlineData("okuma-osp", "G15", NcMeaning.WorkOffset)]
    [InlineData("okuma-osp", "G43", NcMeaning.OpaqueTransformOff)]
    [InlineData("delta-nc300", "G51.1", NcMeaning.Mirroring)]
    [InlineData("siemens-840d", "G20", NcMeaning.Unknown)]
    [InlineData("siemens-840d", "G700", NcMeaning.Inch)]
    [InlineData("siemens-840d", "G505", NcMeaning.WorkOffset)]
    [InlineData("siemens-840d", "G642", NcMeaning.Smoothing)]
    [InlineData("siemens-840d", "G58", NcMeaning.Unknown)]
    [InlineData("linuxcnc", "G90.1", NcMeaning.AbsoluteCenters)]
    [InlineData("linuxcnc", "G68", NcMeaning.Unknown)]
    [InlineData("linuxcnc", "G5.2", NcMeaning.Spline)]
    public void Codes_mean_what_the_controls_say(string name, string code, NcMeaning meaning) =>
        Assert.Equal(meaning, NcDialects.Named(name).MeaningOf(TenthsOf(code).Single()));

    [Theory]
    [InlineData("TRANS", NcMeaning.FrameShift)]
    [InlineData("atrans", NcMeaning.FrameShiftMore)]
    [InlineData("Rot", NcMeaning.FrameRotation)]
    [InlineData("AMIRROR", NcMeaning.FrameMirrorMore)]
    [InlineData("CIP", NcMeaning.ArcThrough)]
    [InlineData("CT", NcMeaning.TangentArc)]
    [InlineData("SUPA", NcMeaning.SuppressFrames)]
    [InlineData("COMPCAD", NcMeaning.Smoothing)]
    [InlineData("TRAORI", NcMeaning.OpaqueTransform)]
    [InlineData("TRAFOOF", NcMeaning.OpaqueTransformOff)]
    [InlineData("CYCLE81", NcMeaning.CycleCall)]
    [InlineData("cycle978", NcMeaning.CycleCall)]
    [InlineData("CYCLE89", NcMeaning.CycleCall)]
    [InlineData("CYCLE90", NcMeaning.CycleCall)]
    [InlineData("HOLES2", NcMeaning.CycleCall)]
    [InlineData("WALCS1", NcMeaning.Harmless)]
    [InlineData("TOWSTD", NcMeaning.Harmless)]
    [InlineData("CYCLE800", NcMeaning.OpaqueTransform)]
    [InlineData("MCALL", NcMeaning.ModalCycle)]
    [InlineData("MSG", NcMeaning.Harmless)]
    [InlineData("MEAS", NcMeaning.ProbeInBlock)]
    [InlineData("CYCLE8", NcMeaning.Unknown)]
    [InlineData("", NcMeaning.Unknown)]
    public void Siemens_words_have_meanings_whatever_their_case(string word, NcMeaning meaning) =>
        Assert.Equal(meaning, NcDialects.Siemens840D.MeaningOf(Encoding.ASCII.GetBytes(word)));

    [Fact]
    public void Words_are_looked_up_without_allocation()
    {
        var dialect = NcDialects.Siemens840D;

        // Once before: what is made at the first question of its kind is no allocation of a look-up.
        LookUp();
        var before = GC.GetAllocatedBytesForCurrentThread();
        for (var i = 0; i < 1000; i++)
        {
            LookUp();
        }

        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);

        void LookUp()
        {
            _ = dialect.MeaningOf("Trans"u8);
            _ = dialect.RoleOf("turn"u8);
            _ = dialect.IsFlow("gotof"u8);
            _ = dialect.IsMachineProgram("L9810"u8);
        }
    }

    [Fact]
    public void Ends_of_transformations_belong_to_what_they_end()
    {
        var (fanuc, siemens) = (NcDialects.FanucMill, NcDialects.Siemens840D);
        Assert.Equal(fanuc.FamilyOf(434), fanuc.FamilyOf(490));
        Assert.Equal(fanuc.FamilyOf(121), fanuc.FamilyOf(131));
        Assert.Equal(fanuc.FamilyOf(682), fanuc.FamilyOf(690));
        Assert.Equal(3, new[] { fanuc.FamilyOf(434), fanuc.FamilyOf(121), fanuc.FamilyOf(682) }.Distinct().Count());
        Assert.Equal(siemens.FamilyOf("TRAORI"u8), siemens.FamilyOf("trafoof"u8));
        Assert.NotEqual(siemens.FamilyOf("TRAFOOF"u8), siemens.FamilyOf("CYCLE800"u8));
        Assert.Equal(0, fanuc.FamilyOf(10));
    }

    [Fact]
    public void Siemens_chooses_the_unit_of_lengths_apart_from_that_of_feeds()
    {
        var siemens = NcDialects.Siemens840D;
        Assert.Equal([false, false, true, true, true], new[] { 700, 710, 7000, 7100, 10 }.Select(siemens.ScalesFeed));
        Assert.True(NcDialects.FanucMill.ScalesFeed(200));
    }

    [Fact]
    public void Functions_call_end_and_return()
    {
        Assert.Equal(
            [FunctionRole.ProgramEnd, FunctionRole.Call, FunctionRole.Return, FunctionRole.Harmless],
            new[] { 30, 98, 99, 8 }.Select(NcDialects.FanucMill.FunctionOf));
        Assert.Equal(
            [FunctionRole.Return, FunctionRole.Harmless, FunctionRole.Unknown, FunctionRole.Unknown],
            new[] { 17, 98, 10_000, -1 }.Select(NcDialects.Siemens840D.FunctionOf));
        Assert.Equal(FunctionRole.RestoreModes, NcDialects.LinuxCnc.FunctionOf(72));
        Assert.Equal([98], NcDialects.LinuxCnc.CallFunctions);
    }

    [Fact]
    public void Programs_of_a_probe_maker_are_in_the_machine()
    {
        Assert.Equal([true, true, false, false], new[] { 9810, 9832, 1000, 9900 }.Select(NcDialects.DeltaNc300.IsMachineProgram));
        Assert.True(NcDialects.Siemens840D.IsMachineProgram("l9810"u8));
        Assert.False(NcDialects.Siemens840D.IsMachineProgram("POCKET_A"u8));
    }

    [Fact]
    public void Flow_words_are_found_in_any_case()
    {
        Assert.True(NcDialects.Siemens840D.IsFlow("GotoF"u8));
        Assert.Contains("ENDWHILE", NcDialects.LinuxCnc.FlowKeywords);
        Assert.False(NcDialects.FanucMill.IsFlow("GOTOF"u8));
    }

    private static string PathTo(string name) => Repository.PathTo("src", "ErrorMatching.Nc", "Dialects", name + ".json");

    // Written apart from the reader's own parser.
    private static IEnumerable<int> TenthsOf(string subject)
    {
        if (subject[0] != 'G' || !char.IsAsciiDigit(subject[1]))
        {
            return [];
        }

        var ends = subject.Split("..")
            .Select(c => (int)(decimal.Parse(c[1..], System.Globalization.CultureInfo.InvariantCulture) * 10))
            .ToArray();
        return Enumerable.Range(0, 10_000).Where(t => t >= ends[0] && t <= ends[^1] && (t - ends[0]) % 10 == 0);
    }
}
