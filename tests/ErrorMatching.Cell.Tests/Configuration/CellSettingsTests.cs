using ErrorMatching.Measurement;

namespace ErrorMatching.Cell.Tests;

public sealed class CellSettingsTests : IDisposable
{
    private readonly CellFolder _cell = new();

    public void Dispose() => _cell.Dispose();

    [Fact]
    public void Paths_start_from_the_folder_of_the_file_and_are_absolute()
    {
        var settings = _cell.Read(CellFolder.Right);
        Assert.Equal(new SqliteSettings(_cell.PathOf("store/cell.db")), settings.Store);
        Assert.Equal((_cell.PathOf("keys"), _cell.PathOf("logs")), (settings.KeysFolder, settings.LogFolder));
        Assert.Equal(_cell.PathOf("incoming"), settings.Gauges[0].Incoming);
        Assert.Equal(new FolderSettings(_cell.PathOf("machine")), settings.Machines[0].Transport);
        Assert.Equal((_cell.PathOf("jobs/freeform.json"), _cell.PathOf("jobs/cam.nc")), (settings.Jobs[3].File, settings.Jobs[3].Program));
    }

    [Fact]
    public void What_is_left_out_has_its_default()
    {
        var settings = _cell.Read(CellFolder.Right);
        var (folder, log) = (settings.Gauges[0], settings.Gauges[1]);
        Assert.Equal((TimeSpan.FromMilliseconds(200), 16_000_000), (folder.Every, folder.MostBytes));
        Assert.Equal((TimeSpan.FromSeconds(2), true), (log.Every, log.KeepsFile));
        Assert.Equal((TimeSpan.FromSeconds(30), 3), (settings.Machines[0].Timeout, settings.Machines[0].Attempts));
        Assert.Equal(new FtpSettings("vmc2", 21, "nc", "/nc", FtpTls.None, null), settings.Machines[1].Transport);
        Assert.Equal(new SftpSettings("vmc3", 22, "nc", ".", CellFolder.HostKey, null), settings.Machines[2].Transport);
        Assert.Equal((true, false), (settings.Jobs[0].InOrderOfSerial, settings.Jobs[0].Accumulates));
        Assert.Equal(
            990,
            (
                (FtpSettings)_cell.Read(CellFolder.With(
                    "\"tls\": \"none\"",
                    "\"tls\": \"implicit\", \"pinnedKey\": \"sha256//47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=\""))
                    .Machines[1].Transport).Port);
    }

    [Fact]
    public void What_says_what_a_machine_is_doing_has_its_kind_its_limits_and_its_defaults()
    {
        Assert.Null(_cell.Read(CellFolder.Right).Machines[0].State);
        Assert.Equal(
            new LinuxCncSettings("vmc1", 5007),
            State("\"kind\": \"linuxcnc\", \"host\": \"vmc1\""));
        Assert.Equal(
            new MtConnectSettings(new("http://vmc1:5000"), "VMC1", true)
            {
                Timeout = TimeSpan.FromSeconds(2),
                WaitLimit = TimeSpan.FromMinutes(30),
                OnlyIdle = true,
            },
            State("\"kind\": \"mtconnect\", \"url\": \"http://vmc1:5000\", \"device\": \"VMC1\", \"stopped\": \"idle\", \"timeoutS\": 2, "
                + "\"waitLimitMin\": 30, \"replaceWhile\": \"idle\""));
        Assert.Equal(
            new StateFileSettings(_cell.PathOf("plc/vmc1.txt"), TimeSpan.FromSeconds(10)) { WaitLimit = TimeSpan.FromHours(8) },
            State("\"kind\": \"file\", \"file\": \"plc/vmc1.txt\""));

        StateSettings? State(string members) => _cell.Read(CellFolder.With(
            "\"folder\": \"machine\" },", $"\"folder\": \"machine\" }}, \"state\": {{ {members} }},")).Machines[0].State;
    }

    [Fact]
    public void A_rule_of_finished_files_is_at_rest_unless_said_otherwise_and_of_a_controls_log_its_end()
    {
        Assert.Equal(new FinishedByRename(), _cell.Read(CellFolder.Right).Gauges[0].Finished);
        Assert.Equal(new FinishedByEndMark("END"), _cell.Read(CellFolder.Right).Gauges[1].Finished);
        Assert.Equal(
            new FinishedByEndMark("END"), _cell.Read(CellFolder.With(", \"finished\": { \"endMark\": \"END\" }", "")).Gauges[1].Finished);
        Assert.Equal(
            new FinishedByMarker(".done"),
            _cell.Read(CellFolder.With("\"finished\": \"rename\"", "\"finished\": { \"marker\": \".done\" }")).Gauges[0].Finished);
        Assert.Equal(
            new FinishedAtRest(TimeSpan.FromSeconds(0.5)),
            _cell.Read(CellFolder.With("\"finished\": \"rename\"", "\"finished\": { \"atRestS\": 0.5 }")).Gauges[0].Finished);
        Assert.Equal(
            new FinishedAtRest(TimeSpan.FromSeconds(2)), _cell.Read(CellFolder.With(", \"finished\": \"rename\"", "")).Gauges[0].Finished);
    }

    [Fact]
    public void A_format_is_a_name_or_a_description_and_none_for_a_log()
    {
        Assert.Same(MeasurementFormat.Points, _cell.Read(CellFolder.Right).Gauges[0].Format);
        Assert.Null(_cell.Read(CellFolder.Right).Gauges[1].Format);
        Assert.Equal(
            ';',
            _cell.Read(CellFolder.With(
                "\"format\": \"points\"", "\"format\": { \"delimiter\": \";\", \"decimalComma\": true }")).Gauges[0].Format!.Delimiter);
    }

    [Fact]
    public void The_piece_follows_from_the_kind_of_job_unless_its_own_rules_say_it() =>
        Assert.Equal(["part", "counterpart", null, "surface"], _cell.Read(CellFolder.Right).Jobs.Select(j => j.Piece));

    [Fact]
    public void A_piece_may_be_said_where_the_job_has_no_rules() =>
        Assert.Equal("counterpart", _cell.Read(CellFolder.With("\"order\": \"serial\"", "\"piece\": \"counterpart\"")).Jobs[0].Piece);

    [Fact]
    public void A_jobs_policy_has_the_cells_in_what_it_leaves_out()
    {
        var settings = _cell.Read(CellFolder.Right);
        Assert.Equal(new(true, 0.2, 0.5, 1.0), settings.Policy);
        Assert.Equal(new(true, 0.2, 0.6, 1.0), settings.Jobs[1].Policy);
        Assert.Null(settings.Jobs[0].Policy);
    }

    [Fact]
    public void Without_a_policy_a_person_approves()
    {
        var settings = _cell.Read(CellFolder.With(
            ",\n  \"policy\": { \"approve\": \"automatic\", \"limitMm\": 0.2, \"sumLimitMm\": 0.5, \"gain\": 1.0 }", ""));
        Assert.Equal(new(false, null, null, null), settings.Policy);
    }

    [Fact]
    public void What_is_unwise_is_warned_of_at_its_place()
    {
        var text = CellFolder.With("\"gauges\": [\"probe\"]", "\"gauges\": [\"cmm\"]")
            .Replace(
                "{ \"headerField\": { \"name\": \"PLAN\", \"pattern\": \"^[0-9A-F]{16}$\" } }",
                "{ \"fileName\": \"^blade\" }",
                StringComparison.Ordinal)
            .Replace("\"slot\": \"B\"", "\"slot\": \"A\"", StringComparison.Ordinal);
        Assert.Equal(
            [
                "7:15 unused-gauge $.gauges[1].name",
                "11:91 unused-slot $.machines[0].slots[1].name",
                "12:134 plain-ftp $.machines[1].transport.tls"],
            _cell.Read(text).Warnings.Select(w => $"{w.Place.Line}:{w.Place.Column} {w.Code} {w.Place.Path}"));
    }

    [Fact]
    public void The_template_passes_beside_a_job_of_its_name()
    {
        _cell.Write("job.json", File.ReadAllText(_cell.PathOf("jobs/mating.json")));
        var settings = _cell.Read(CellTemplate.Text);
        Assert.Equal("housing", Assert.Single(settings.Jobs).Name);
        Assert.Empty(settings.Warnings);
    }
}
