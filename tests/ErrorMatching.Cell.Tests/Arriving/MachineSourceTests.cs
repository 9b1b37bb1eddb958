using System.Text;

namespace ErrorMatching.Cell.Tests;

public sealed class MachineSourceTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("errormatch-control-").FullName;
    private readonly ManualClock _clock = new();
    private readonly Dictionary<string, string> _archived = new(StringComparer.Ordinal);
    private int _handed;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public async Task A_log_is_finished_when_its_content_has_stayed_the_same()
    {
        var source = Source(new FinishedAtRest(TimeSpan.FromSeconds(2)));
        Write("PROBE.LOG", "P1\n");
        Assert.Equal(0, await Take(source));
        _clock.Advance(TimeSpan.FromSeconds(3));
        Write("PROBE.LOG", "P1\nP2\n");
        Assert.Equal(0, await Take(source));
        _clock.Advance(TimeSpan.FromSeconds(2));
        Assert.Equal(1, await Take(source));
        Assert.Equal(["PROBE.LOG:P1\nP2\n"], _archived.Values);
    }

    [Fact]
    public async Task A_log_with_its_end_mark_is_finished_at_once()
    {
        var source = Source(new FinishedByEndMark("END"));
        Write("PROBE.LOG", "P1\n");
        Assert.Equal(0, await Take(source));
        Write("PROBE.LOG", "P1\nEND\n");
        Assert.Equal(1, await Take(source));
    }

    [Fact]
    public async Task What_has_a_logs_name_and_is_a_link_is_named_and_left_and_the_others_are_taken()
    {
        var source = Source(new FinishedByEndMark("END"));
        Write("REAL.LOG", "P1\nEND\n");
        File.CreateSymbolicLink(Path.Combine(_folder, "A.LOG"), Path.Combine(_folder, "REAL.LOG"));
        Assert.Equal(1, await Take(source));
        Assert.Equal(["REAL.LOG:P1\nEND\n"], _archived.Values);
        Assert.Equal("A.LOG", Assert.Single(source.Left).Name);
    }

    [Fact]
    public async Task A_log_that_is_kept_is_taken_once_and_again_when_it_is_another()
    {
        var source = Source(new FinishedByEndMark("END"));
        Write("PROBE.LOG", "P1\nEND\n");
        Assert.Equal(1, await Take(source));
        Assert.Equal(0, await Take(source));
        Assert.Equal(1, _handed);
        Write("PROBE.LOG", "P2\nEND\n");
        Assert.Equal(1, await Take(source));
        Assert.Equal(2, _archived.Count);
        Assert.Equal(["PROBE.LOG"], Files());
    }

    [Fact]
    public async Task After_a_restart_a_kept_log_is_handed_over_with_the_same_key()
    {
        Write("PROBE.LOG", "P1\nEND\n");
        await Take(Source(new FinishedByEndMark("END")));
        await Take(Source(new FinishedByEndMark("END")));
        Assert.Equal(2, _handed);
        Assert.Single(_archived);
    }

    [Fact]
    public async Task A_log_that_is_not_kept_is_deleted_once_it_is_archived()
    {
        var source = Source(new FinishedByEndMark("END"), keeps: false);
        Write("PROBE.LOG", "P1\nEND\n");
        Write("O1.NC", "other");
        Assert.Equal(1, await Take(source));
        Assert.Equal(["O1.NC"], Files());
        Assert.Equal(1, _handed);
    }

    [Fact]
    public async Task What_the_control_adds_before_the_log_is_deleted_is_archived_too()
    {
        var source = Source(new FinishedByEndMark("END"), keeps: false);
        Write("PROBE.LOG", "P1\nEND\n");
        await Take(source, behind: () =>
        {
            if (_handed == 1)
            {
                Write("PROBE.LOG", "P1\nEND\nP2\nEND\n");
            }
        });
        Assert.Equal(["PROBE.LOG:P1\nEND\n", "PROBE.LOG:P1\nEND\nP2\nEND\n"], _archived.Values);
        Assert.Empty(Files());
    }

    [Fact]
    public async Task What_an_earlier_run_renamed_is_archived_first()
    {
        Write("PROBE.LOG.taken", "P1\nEND\n");
        Write("PROBE.LOG", "P2\nEND\n");
        Assert.Equal(2, await Take(Source(new FinishedByEndMark("END"), keeps: false)));
        Assert.Equal(["PROBE.LOG:P1\nEND\n", "PROBE.LOG:P2\nEND\n"], _archived.Values);
        Assert.Empty(Files());
    }

    [Fact]
    public async Task What_cannot_be_archived_stays_at_the_machine()
    {
        var source = Source(new FinishedByEndMark("END"), keeps: false);
        Write("PROBE.LOG", "P1\nEND\n");
        await Assert.ThrowsAsync<IOException>(() => Take(source, before: () => throw new IOException("full")));
        Assert.Equal(["PROBE.LOG"], Files());
        Assert.Equal(1, await Take(source));
        Assert.Empty(Files());
    }

    [Fact]
    public async Task A_log_that_is_empty_is_one_that_is_being_opened()
    {
        var source = Source(new FinishedAtRest(TimeSpan.Zero));
        Write("PROBE.LOG", "");
        Assert.Equal(0, await Take(source) + await Take(source));
    }

    [Fact]
    public async Task A_log_that_is_too_large_is_named_and_left()
    {
        var source = Source(new FinishedByEndMark("END"));
        Write("PROBE.LOG", new string('x', 2000));
        Assert.Equal(0, await Take(source));
        Assert.Equal("PROBE.LOG", Assert.Single(source.Left).Name);
    }

    [Fact]
    public async Task A_machine_that_is_away_is_an_error_of_its_transport()
    {
        var source = Source(new FinishedByEndMark("END"), folder: Path.Combine(_folder, "none"));
        await Assert.ThrowsAsync<TransportException>(() => Take(source));
    }

    private MachineSource Source(FinishedRule finished, bool keeps = true, string? folder = null)
    {
        var machine = new MachineSettings
        {
            Name = "vmc1",
            Transport = new FolderSettings(folder ?? _folder),
            Dialect = "siemens-840d",
            Slots = [],
            Timeout = TimeSpan.FromMinutes(10),
            Attempts = 1,
        };
        var gauge = new GaugeSettings
        {
            Name = "probe",
            Machine = "vmc1",
            Files = "*.LOG",
            Finished = finished,
            Format = null,
            MostBytes = 1000,
            Every = TimeSpan.FromSeconds(2),
            KeepsFile = keeps,
        };
        return new(gauge, MachineFolders.Open(machine, () => null), _clock);
    }

    private Task<int> Take(MachineSource source, Action? before = null, Action? behind = null) => source.TakeAsync(
        arrival =>
        {
            before?.Invoke();
            _handed++;
            _archived.TryAdd(arrival.Key, $"{arrival.FileName}:{Encoding.UTF8.GetString(arrival.Bytes.Span)}");
            behind?.Invoke();
        },
        TestContext.Current.CancellationToken);

    private void Write(string name, string text) => File.WriteAllText(Path.Combine(_folder, name), text);

    private IEnumerable<string> Files() => Directory.GetFiles(_folder).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal);
}
