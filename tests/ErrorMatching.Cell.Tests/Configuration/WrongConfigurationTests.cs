using ErrorMatching.Refusals;

namespace ErrorMatching.Cell.Tests;

/// <summary>The right configuration with one thing wrong: each is found at its path and line, and nothing else is.</summary>
public sealed class WrongConfigurationTests : IDisposable
{
    private const string Slots = "\"slots\": [{ \"name\": \"A\", \"program\": \"O3001.NC\" }]";
    private const string Folder = "\"transport\": { \"kind\": \"folder\", \"folder\": \"machine\" },";
    private readonly CellFolder _cell = new();

    /// <summary>What stands in the right configuration, what takes its place, and the line, path,
    /// code and part of the sentence of the only problem.</summary>
    public static TheoryData<string, string, int, string, string, string> Table => new()
    {
        // As JSON and by the schema.
        { "\"kind\": \"cell\", ", "", 1, "$", "missing-key", "\"kind\"" },
        { "\"kind\": \"cell\"", "\"kind\": \"sell\"", 2, "$.kind", "not-one-of", "expected \"cell\"" },
        { "\"name\": \"Cell 1\"", "\"name\": \"\"", 2, "$.name", "pattern-mismatch", "one line" },
        { "\"name\": \"Cell 1\"", "\"name\": \"Cell\\u0007\"", 2, "$.name", "control-character", "printable text" },
        { "\"kind\": \"sqlite\"", "\"kind\": \"oracle\"", 3, "$.store.kind", "not-one-of", "\"sqlite\" or \"postgresql\"" },
        { "\"logs\": \"logs\"", "\"lgos\": \"logs\"", 4, "$.lgos", "unknown-key", "did you mean \"logs\"?" },
        { "\"name\": \"cmm\"", "\"name\": \"c m m\"", 6, "$.gauges[0].name", "pattern-mismatch", "letters, digits" },
        { "\"files\": \"*.csv\"", "\"files\": \"in/*.csv\"", 6, "$.gauges[0].files", "pattern-mismatch", "the name of a file" },
        { "\"finished\": \"rename\"", "\"finished\": \"soon\"", 6, "$.gauges[0].finished", "not-one-of", "\"rename\"" },
        { "\"finished\": \"rename\"", "\"finished\": { \"atRestS\": 0 }", 6, "$.gauges[0].finished.atRestS", "too-small", "more than 0" },
        { "\"finished\": \"rename\"", "\"mostMB\": 1000", 6, "$.gauges[0].mostMB", "too-large", "at most 256" },
        { "\"finished\": \"rename\"", "\"everyMs\": 1.5", 6, "$.gauges[0].everyMs", "wrong-type", "a whole number" },
        { "\"host\": \"vmc2\"", "\"host\": \"-vmc2\"", 12, "$.machines[1].transport.host", "pattern-mismatch", "the name or address" },
        { "\"host\": \"vmc2\"", "\"host\": \"vmc2\\n\"", 12, "$.machines[1].transport.host", "control-character", "printable" },
        { "\"host\": \"vmc2\"", "\"host\": \"vmc2\", \"port\": 70000", 12, "$.machines[1].transport.port", "too-large", "65535" },
        {
            "\"folder\": \"/nc\"",
            "\"folder\": \"/nc\\\"; rm\"",
            12,
            "$.machines[1].transport.folder",
            "pattern-mismatch",
            "without quotes"
        },
        { ", \"hostKey\": \"" + CellFolder.HostKey + "\"", "", 15, "$.machines[2].transport", "missing-key", "\"hostKey\"" },
        { "\"approve\": \"automatic\"", "\"approve\": \"always\"", 28, "$.policy.approve", "not-one-of", "\"person\" or \"automatic\"" },
        { "\"gain\": 1.0", "\"gain\": 3", 28, "$.policy.gain", "too-large", "at most 2" },
        { "\"gauges\": [\"probe\"]", "\"gauges\": []", 25, "$.jobs[3].gauges", "too-few-items", "at least 1" },

        // What says what a machine is doing.
        { Slots, State("opcua", "") + Slots, 16, "$.machines[2].state.kind", "not-one-of", "\"linuxcnc\"" },
        { Slots, State("linuxcnc", "") + Slots, 16, "$.machines[2].state", "missing-key", "\"host\"" },
        { Slots, State("mtconnect", "url\": \"ftp://vmc3") + Slots, 16, "$.machines[2].state.url", "pattern-mismatch", "http://" },
        { Slots, State("mtconnect", "url\": \"http://me:it@vmc3") + Slots, 16, "$.machines[2].state.url", "bad-agent-url", "\"...@vmc3\"" },
        { Slots, State("mtconnect", "url\": \"http://vmc3/?a=b") + Slots, 16, "$.machines[2].state.url", "bad-agent-url", "no password" },
        { Folder, Folder + State("file", "file\": \"machine/plc.txt"), 10, "$.machines[0].state.file", "inside-machine", "state" },

        // Names.
        {
            "{ \"name\": \"probe\",",
            "{ \"name\": \"CMM\", \"incoming\": \"x\", \"files\": \"*\" }, { \"name\": \"probe\",",
            7,
            "$.gauges[1].name",
            "duplicate-name",
            "the gauge \"CMM\" again"
        },
        {
            "{ \"name\": \"vmc3\",",
            "{ \"name\": \"vmc1\", \"dialect\": \"fanuc\", \"transport\": { \"kind\": \"folder\", \"folder\": \"x\" }, \"slots\": [{ "
                + "\"name\": \"A\", \"program\": \"X\" }] }, { \"name\": \"vmc3\",",
            14,
            "$.machines[2].name",
            "duplicate-name",
            "the machine \"vmc1\" again"
        },
        { "\"name\": \"cover\"", "\"name\": \"housing\"", 23, "$.jobs[2].name", "duplicate-name", "the job \"housing\" again" },
        {
            "{ \"name\": \"B\",",
            "{ \"name\": \"a\", \"program\": \"X\" }, { \"name\": \"B\",",
            11,
            "$.machines[0].slots[1].name",
            "duplicate-name",
            "the slot \"a\" again"
        },
        { "\"gauges\": [\"probe\"]", "\"gauges\": [\"prob\"]", 25, "$.jobs[3].gauges[0]", "unknown-gauge", "one of \"cmm\", \"probe\"" },
        {
            "\"machine\": \"vmc2\", \"slot\": \"A\"",
            "\"machine\": \"vmc4\", \"slot\": \"A\"",
            25,
            "$.jobs[3].machine",
            "unknown-machine",
            "\"vmc1\", \"vmc2\", \"vmc3\""
        },
        { "\"slot\": \"B\"", "\"slot\": \"C\"", 21, "$.jobs[1].slot", "unknown-slot", "a slot of vmc1: one of \"A\", \"B\"" },
        { "\"machine\": \"vmc2\", \"files\"", "\"machine\": \"vmc9\", \"files\"", 7, "$.gauges[1].machine", "unknown-machine", "\"vmc9\"" },

        // Programs and ready files at machines.
        { "\"program\": \"O2002.NC\"", "\"program\": \"o2001.nc\"", 11, "$.machines[0].slots[1].program", "program-of-two-slots", "again" },
        { "\"program\": \"O2002.NC\"", "\"program\": \"2001.TXT\"", 11, "$.machines[0].slots[1].program", "program-of-two-slots",
            "cannot tell from" },
        {
            "\"program\": \"O2002.NC\"",
            "\"program\": \"../O2002.NC\"",
            11,
            "$.machines[0].slots[1].program",
            "bad-program-name",
            "1 to 64"
        },
        {
            "\"program\": \"O2002.NC\"",
            "\"program\": \"-O2002.NC\"",
            11,
            "$.machines[0].slots[1].program",
            "bad-program-name",
            "dash in front"
        },
        { "\"program\": \"O2002.NC\"", "\"program\": \"con.nc\"", 11, "$.machines[0].slots[1].program", "bad-program-name", "Windows" },
        { "\"program\": \"O2002.NC\"", "\"program\": \"\"", 11, "$.machines[0].slots[1].program", "bad-program-name", "1 to 64" },
        {
            "\"readyFile\": \"A.READY\"",
            "\"readyFile\": \"O2002.NC\"",
            11,
            "$.machines[0].slots[0].readyFile",
            "ready-file-is-program",
            "deletes"
        },
        { "\"readyFile\": \"A.READY\"", "\"readyFile\": \".ready\"", 11, "$.machines[0].slots[0].readyFile", "bad-program-name", "no dot" },

        // Gauges.
        { "\"incoming\": \"incoming\", ", "", 6, "$.gauges[0]", "source-missing", "neither a folder nor a machine" },
        {
            "\"machine\": \"vmc2\", \"files\"",
            "\"incoming\": \"other\", \"machine\": \"vmc2\", \"files\"",
            7,
            "$.gauges[1].machine",
            "source-twice",
            "not both"
        },
        { "\"format\": \"points\"", "\"format\": \"poinst\"", 6, "$.gauges[0].format", "bad-format", "\"probing-log\"" },
        { "\"format\": \"points\"", "\"format\": { \"delimiter\": \"x\" }", 6, "$.gauges[0].format.delimiter", "bad-format", "one of" },
        { "\"finished\": \"rename\"", "\"finished\": {}", 6, "$.gauges[0].finished", "finished-rules", "no rule" },
        {
            "\"finished\": \"rename\"",
            "\"finished\": { \"marker\": \".d\", \"endMark\": \"E\" }",
            6,
            "$.gauges[0].finished",
            "finished-rules",
            "2 rules"
        },
        { "\"finished\": \"rename\"", "\"keep\": true", 6, "$.gauges[0].keep", "keep-without-machine", "always taken" },
        { "{ \"endMark\": \"END\" }", "\"rename\"", 7, "$.gauges[1].finished", "finished-at-machine", "own name" },
        { "{ \"endMark\": \"END\" }", "{ \"marker\": \".done\" }", 7, "$.gauges[1].finished.marker", "finished-at-machine", "atRestS" },
        { "{ \"endMark\": \"END\" }", "{ \"endMark\": \" END\" }", 7, "$.gauges[1].finished.endMark", "end-mark-spaces", "spaces" },
        { "\"files\": \"PROBE.LOG\"", "\"files\": \"*.MPF\"", 7, "$.gauges[1].files", "files-of-slot", "FINISH.MPF" },
        {
            "{ \"name\": \"probe\",",
            "{ \"name\": \"cmm2\", \"incoming\": \"./incoming/\", \"files\": \"WO*\" }, { \"name\": \"probe\",",
            7,
            "$.gauges[1].files",
            "overlapping-files",
            "\"WO*\" beside \"*.csv\" of \"cmm\""
        },

        // Folders.
        { "\"incoming\": \"incoming\"", "\"incoming\": \"machine/in\"", 6, "$.gauges[0].incoming", "incoming-at-machine", "vmc1" },
        {
            "\"folder\": \"machine\"",
            "\"folder\": \"incoming/../incoming\"",
            6,
            "$.gauges[0].incoming",
            "incoming-at-machine",
            "none lies in the other"
        },
        { "\"file\": \"store/cell.db\"", "\"file\": \"incoming/cell.db\"", 3, "$.store.file", "inside-incoming", "the store" },
        { "\"logs\": \"logs\"", "\"logs\": \"machine/logs\"", 4, "$.logs", "inside-machine", "vmc1" },
        { "\"keys\": \"keys\"", "\"keys\": \"incoming/keys\"", 4, "$.keys", "inside-incoming", "the folder of keys" },
        {
            "{ \"name\": \"vmc3\",",
            "{ \"name\": \"vmc0\", \"dialect\": \"fanuc\", \"transport\": { \"kind\": \"folder\", \"folder\": \"machine/sub\" }, "
                + "\"slots\": [{ \"name\": \"A\", \"program\": \"X\" }] }, { \"name\": \"vmc3\",",
            14,
            "$.machines[2].transport",
            "folder-of-two-machines",
            "the folder of vmc1 again"
        },

        // Ways to machines.
        { "\"tls\": \"none\"", "\"tls\": \"explicit\"", 12, "$.machines[1].transport", "pin-missing", "sha256//" },
        {
            "\"tls\": \"none\"",
            "\"tls\": \"none\", \"pinnedKey\": \"sha256//47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=\"",
            12,
            "$.machines[1].transport.pinnedKey",
            "pin-without-tls",
            "not encrypted"
        },
        {
            "\"tls\": \"none\"",
            "\"tls\": \"implicit\", \"pinnedKey\": \"sha256//short\"",
            12,
            "$.machines[1].transport.pinnedKey",
            "pattern-mismatch",
            "base 64"
        },
        { "\"folder\": \"/nc\"", "\"folder\": \"/nc/../etc\"", 12, "$.machines[1].transport.folder", "folder-leads-up", "without .." },
        {
            CellFolder.HostKey,
            CellFolder.HostKey.Replace("ed25519", "rsa", StringComparison.Ordinal),
            15,
            "$.machines[2].transport.hostKey",
            "bad-host-key",
            "known_hosts"
        },
        { CellFolder.HostKey, "ssh-ed25519 AAAA", 15, "$.machines[2].transport.hostKey", "bad-host-key", "whole" },

        // Jobs.
        { "\"job\": \"jobs/mating.json\"", "\"job\": \"jobs/none.json\"", 19, "$.jobs[0].job", "job-missing", "none.json" },
        { "\"job\": \"jobs/mating.json\"", "\"job\": \"jobs\"", 19, "$.jobs[0].job", "job-missing", "cannot be read" },
        {
            "\"dialect\": \"delta-nc300\",\n      \"transport\"",
            "\"dialect\": \"fanuc\",\n      \"transport\"",
            23,
            "$.jobs[2].job",
            "other-dialect",
            "fanuc, which vmc3 has"
        },
        { "\"dialect\": \"siemens-840d\"", "\"dialect\": \"siemens\"", 12, "$.machines[1].dialect", "unknown-dialect", "\"siemens-840d\"" },
        { "\"order\": \"serial\"", "\"piece\": \"surface\"", 19, "$.jobs[0].piece", "piece-of-other-kind", "a mating job" },
        { "\"program\": \"jobs/cam.nc\"", "\"piece\": \"part\"", 25, "$.jobs[3].piece", "piece-of-other-kind", "a free-form job" },
        {
            "\"machine\": \"vmc3\", \"slot\": \"A\"",
            "\"machine\": \"vmc3\", \"slot\": \"A\", \"piece\": \"part\"",
            23,
            "$.jobs[2].piece",
            "piece-decided-twice",
            "recognition"
        },
        {
            "\"order\": \"serial\"",
            "\"program\": \"jobs/cam.nc\"",
            19,
            "$.jobs[0].program",
            "program-for-mating",
            "names its program itself"
        },
        { "\"order\": \"serial\"", "\"accumulates\": true", 19, "$.jobs[0].accumulates", "accumulates-without-feedback", "feedback" },
        {
            "\"slot\": \"A\", \"program\": \"jobs/cam.nc\",",
            "\"slot\": \"A\", \"order\": \"serial\",",
            25,
            "$.jobs[3].order",
            "serial-missing",
            "(?<serial>...)"
        },
        {
            "{ \"sumLimitMm\": 0.6 }",
            "{ \"sumLimitMm\": 0.1 }",
            22,
            "$.jobs[1].policy.sumLimitMm",
            "sum-limit-too-small",
            "0.1 mm, less than the 0.2 mm"
        },
        {
            "\"name\": \"PLAN\", \"pattern\"",
            "\"name\": \"\", \"pattern\"",
            26,
            "$.jobs[3].recognize.headerField.name",
            "pattern-mismatch",
            "one line"
        },

        // Patterns.
        {
            "{ \"fileName\": \"^fb_\", \"column\": { \"name\": \"serial\", \"pattern\": \"^(?<serial>[0-9]+)$\" } }",
            "{}",
            22,
            "$.jobs[1].recognize",
            "recognition-missing",
            "every file"
        },
        { "\"^cover\"", "\"^(cover\"", 24, "$.jobs[2].recognize.fileName", "bad-pattern", "look-around" },
        { "\"^cover\"", "\"(?=cover)\"", 24, "$.jobs[2].recognize.fileName", "bad-pattern", "look-around" },
        { "\"^cover\"", "\"(.)\\\\1\"", 24, "$.jobs[2].recognize.fileName", "bad-pattern", "back references" },
        { "\"^cover\"", "\"^(?<serail>C)\"", 24, "$.jobs[2].recognize.fileName", "unknown-group", "serial, workOrder or toolChanged" },
        {
            "{ \"name\": \"serial\", \"pattern\": \"^(?<serial>C[0-9]+)$\" }",
            "{ \"name\": \"serial\" }",
            24,
            "$.jobs[2].recognize.column",
            "missing-key",
            "\"pattern\""
        },
        {
            "\"headerField\": { \"name\": \"PLAN\"",
            "\"column\": { \"name\": \"PLAN\"",
            26,
            "$.jobs[3].recognize.column",
            "column-of-log",
            "headerField"
        },
        {
            "\"column\": { \"name\": \"serial\", \"pattern\": \"^(?<serial>C",
            "\"headerField\": { \"name\": \"serial\", \"pattern\": \"^(?<serial>C",
            24,
            "$.jobs[2].recognize.headerField",
            "no-header-fields",
            "skipLines"
        },
    };

    public void Dispose() => _cell.Dispose();

    [Theory]
    [MemberData(nameof(Table))]
    public void Each_wrong_thing_is_named_by_path_and_line(string right, string wrong, int line, string path, string code, string words)
    {
        var problem = Assert.Single(Problems(CellFolder.With(right, wrong)));
        Assert.Equal((code, path, line), (problem.Code, problem.Place.Path, problem.Place.Line));
        Assert.Contains(words, problem.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void All_problems_are_told_at_once_in_the_order_of_the_file()
    {
        var text = CellFolder.With("\"slot\": \"B\"", "\"slot\": \"C\"")
            .Replace("\"program\": \"O2002.NC\"", "\"program\": \"nul\"", StringComparison.Ordinal)
            .Replace("\"tls\": \"none\"", "\"tls\": \"explicit\"", StringComparison.Ordinal)
            .Replace("{ \"sumLimitMm\": 0.6 }", "{ \"sumLimitMm\": 0.1 }", StringComparison.Ordinal);
        Assert.Equal(["bad-program-name", "pin-missing", "unknown-slot", "sum-limit-too-small"], Problems(text).Select(p => p.Code));
    }

    [Fact]
    public void Each_error_of_a_jobs_file_is_told_with_its_own_place()
    {
        var job = _cell.Write("jobs/mating.json", File.ReadAllText(_cell.PathOf("jobs/mating.json"))
            .Replace("\"kind\": \"mating\"", "\"kind\": \"mating\", \"knid\": 1", StringComparison.Ordinal)
            .Replace("\"gain\": 1.0", "\"gain\": 5", StringComparison.Ordinal));
        var problems = Problems(CellFolder.Right);
        Assert.Equal(
            [("unknown-key", "$.jobs[0].job", 19), ("too-large", "$.jobs[0].job", 19)],
            problems.Select(p => (p.Code, p.Place.Path, p.Place.Line)));
        Assert.StartsWith($"in {job}, line 3, column 21, $.knid: ", problems[0].Message, StringComparison.Ordinal);
        Assert.Contains("$.compensation.gain: ", problems[1].Message, StringComparison.Ordinal);
    }

    [Fact]
    public void An_input_that_a_gauge_would_take_is_named()
    {
        var problems = Problems(CellFolder.With("\"incoming\": \"incoming\"", "\"incoming\": \"jobs\""));
        Assert.All(problems, p => Assert.Equal("input-taken", p.Code));
        Assert.Contains(problems, p => p.Place.Path == "$.jobs[0].job" && p.Message.Contains("theoretical.csv", StringComparison.Ordinal));
        Assert.Contains(problems, p => p.Place.Path == "$.jobs[2].job" && p.Message.Contains("part.csv", StringComparison.Ordinal));
    }

    [Fact]
    public void An_original_that_the_cell_would_overwrite_is_named()
    {
        var problems = Problems(
            CellFolder.With("\"folder\": \"machine\"", "\"folder\": \"jobs\"")
                .Replace("\"O3001.NC\"", "\"counterpart.nc\"", StringComparison.Ordinal)
                .Replace("\"O2002.NC\"", "\"COUNTERPART.NC\"", StringComparison.Ordinal)
                .Replace("jobs/feedback.json", "jobs/mating.json", StringComparison.Ordinal)
                .Replace("jobs/ruled.json", "jobs/mating.json", StringComparison.Ordinal)
                .Replace(", \"accumulates\": true", "", StringComparison.Ordinal));
        Assert.Equal(["$.jobs[0].job", "$.jobs[1].job", "$.jobs[2].job"], problems.Select(p => p.Place.Path));
        Assert.All(problems, p => Assert.Equal("original-at-machine", p.Code));
    }

    [Fact]
    public void A_sum_without_a_limit_is_named()
    {
        var problem = Assert.Single(Problems(
            CellFolder.With("\"sumLimitMm\": 0.6", "\"gain\": 0.5").Replace(", \"sumLimitMm\": 0.5", "", StringComparison.Ordinal)));
        Assert.Equal(("sum-limit-missing", "$.jobs[1].accumulates", 21), (problem.Code, problem.Place.Path, problem.Place.Line));
    }

    [Fact]
    public void A_probing_log_for_a_mating_is_named()
    {
        var problem = Assert.Single(Problems(
            CellFolder.With(
                "\"name\": \"cover\", \"job\": \"jobs/ruled.json\", \"gauges\": [\"cmm\"]",
                "\"name\": \"cover\", \"job\": \"jobs/ruled.json\", \"gauges\": [\"cmm\", \"probe\"]")
            .Replace(", \"column\": { \"name\": \"serial\", \"pattern\": \"^(?<serial>C[0-9]+)$\" }", "", StringComparison.Ordinal)));
        Assert.Equal(("log-for-mating", "$.jobs[2].gauges[1]", 23), (problem.Code, problem.Place.Path, problem.Place.Line));
    }

    [Fact]
    public void A_dialects_file_that_is_missing_or_wrong_is_named()
    {
        var missing = Problems(CellFolder.With("\"dialect\": \"siemens-840d\"", "\"dialect\": \"mill.json\""));
        Assert.Contains(missing, p => (p.Code, p.Place.Path) == ("dialect-missing", "$.machines[1].dialect"));
        _cell.Write("mill.json", "{ \"like\": \"siemens-840d\" }");
        Assert.Contains(
            Problems(CellFolder.With("\"dialect\": \"siemens-840d\"", "\"dialect\": \"mill.json\"")),
            p => p is { Code: "missing-key", Place.Path: "$.machines[1].dialect" });
    }

    private IReadOnlyList<Refusal> Problems(string text) => Assert.Throws<InputException>(() => _cell.Read(text)).Refusals;

    private static string State(string kind, string member) =>
        $"\"state\": {{ \"kind\": \"{kind}\"{(member.Length > 0 ? $", \"{member}\"" : "")} }}, ";
}
