using System.Security.Cryptography;
using System.Text;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

/// <summary>A sender that is frozen at any step, and goes on after another one has sent the next program, changes nothing any
/// more.</summary>
public sealed class FrozenSenderTests
{
    private const string Program = "P100.MPF";

    // No transfer has more steps than this.
    private const int MostSteps = 30;

    private static readonly byte[] Old = Encoding.ASCII.GetBytes("G1 X1\nM30\n");
    private static readonly byte[] Mine = Encoding.ASCII.GetBytes("G1 X2\nM30\n");
    private static readonly byte[] Next = Encoding.ASCII.GetBytes("G1 X3\nM30\n");
    private static readonly byte[] Edited = Encoding.ASCII.GetBytes("G1 X1.5 (by hand)\nM30\n");

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    // The program's name never has an older program again. Where names cannot be replaced, it may be taken away, once, and comes back.
    [Theory]
    [InlineData(StepKind.Exchanges, false)]
    [InlineData(StepKind.Exchanges, true)]
    [InlineData(StepKind.Links, false)]
    [InlineData(StepKind.Links, true)]
    [InlineData(StepKind.Replaces, false)]
    [InlineData(StepKind.Refuses, false)]
    [InlineData(StepKind.Refuses, true)]
    public async Task A_sender_frozen_at_any_step_finds_nothing_when_it_goes_on(StepKind kind, bool isEdited)
    {
        var taken = 0;
        for (var step = 0; ; step++)
        {
            Assert.InRange(step, 0, MostSteps);
            var files = new Dictionary<string, byte[]>(StringComparer.Ordinal) { [Program] = Old };
            var frozen = new SteppedFolder(files, kind) { FreezesAt = step };

            // A change comes in the moment before the names change, and must get its place back.
            if (isEdited)
            {
                frozen.Stepping = name =>
                {
                    if (name == "take " + Program && !frozen.IsFenced && files.TryGetValue(Program, out var there) && Same(there, Old))
                        files[Program] = Edited;
                };
            }

            var sending = SendAsync(new ProgramSender(frozen, Keeps), Old, Mine);
            if (!await frozen.IsFrozenAsync(sending))
            {
                await sending;
                Assert.True(step > 3);
                break;
            }

            // Another process has the right now.
            frozen.IsFenced = true;
            var standby = new ProgramSender(new SteppedFolder(files, kind), h => Keeps(h) || h == Hash(Edited));
            await standby.RecoverAsync(Program, Token);
            var found = await standby.CurrentAsync(Program, Token);
            Assert.True(found is not null && (Same(found, Old) || Same(found, Mine) || Same(found, Edited)));
            await standby.SendAsync(Program, Hash(found), Next, "2", Token);

            frozen.Thaw();
            await sending;
            if (kind == StepKind.Refuses && !files.ContainsKey(Program))
            {
                taken++;
                await standby.RecoverAsync(Program, Token);
            }

            Assert.True(Same(files[Program], Next), $"{kind} at {step}, {frozen.Last}: {Encoding.ASCII.GetString(files[Program])}");
            await standby.RecoverAsync(Program, Token);
            Assert.Equal([Program], files.Keys);
            Assert.True(Same(files[Program], Next));
        }

        Assert.True(kind == StepKind.Refuses ? taken > 0 : taken == 0);
    }

    // The same with the system's own renames in a folder.
    [Fact]
    public async Task A_sender_frozen_at_any_step_in_a_folder_finds_nothing_when_it_goes_on()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Only Linux exchanges names.");
        var seen = new List<string>();
        for (var step = 0; ; step++)
        {
            Assert.InRange(step, 0, MostSteps);
            using var folder = new TemporaryFolder();
            var program = folder.File(Program, Encoding.ASCII.GetString(Old));
            using var freeze = new Freeze(step);
            var transport = new FolderTransport("mill", folder.Path, TimeSpan.FromMinutes(1)) { Doing = freeze.Do };
            var isFenced = false;
            var fenced = new FencedFolder(transport, () =>
            {
                if (isFenced) throw new StoreException(StoreError.Away, "The right is lost.");
            });
            var sending = SendAsync(new ProgramSender(fenced, Keeps), Old, Mine);
            if (!await freeze.IsFrozenAsync(sending))
            {
                await sending;
                break;
            }

            seen.Add(freeze.At);
            isFenced = true;
            var standby = new ProgramSender(new FolderTransport("mill", folder.Path, TimeSpan.FromMinutes(1)), Keeps);
            await standby.RecoverAsync(Program, Token);
            var found = await standby.CurrentAsync(Program, Token);
            await standby.SendAsync(Program, Hash(found), Next, "2", Token);
            freeze.Thaw();
            await sending;
            Assert.True(Same(await File.ReadAllBytesAsync(program, Token), Next), $"{step}: {freeze.At}");
            await standby.RecoverAsync(Program, Token);
            Assert.Equal([program], Directory.EnumerateFiles(folder.Path));
        }

        Assert.Contains(seen, s => s.StartsWith("exchanging", StringComparison.Ordinal));
        Assert.Contains(seen, s => s.StartsWith("comparing", StringComparison.Ordinal));
    }

    // What earlier versions left has the name that all attempts shared.
    [Theory]
    [InlineData(StepKind.Exchanges)]
    [InlineData(StepKind.Links)]
    [InlineData(StepKind.Refuses)]
    public async Task What_an_earlier_version_left_is_recovered(StepKind kind)
    {
        var files = new Dictionary<string, byte[]>(StringComparer.Ordinal)
        {
            [Program + ".emold"] = Old,
            [Program + ".17-0123abcd.emnew"] = Mine[..4],
        };
        await new ProgramSender(new SteppedFolder(files, kind), Keeps).RecoverAsync(Program, Token);
        Assert.Equal((Program, Old), Assert.Single(files) is var (name, bytes) ? (name, bytes) : default);
    }

    [Fact]
    public void Names_say_whose_attempt_they_are_and_no_two_are_alike()
    {
        var (one, other) = (ProgramNames.New(Program, "17"), ProgramNames.New(Program, "17"));
        Assert.NotEqual(one, other);
        Assert.Equal(one[..one.LastIndexOf('-')], other[..other.LastIndexOf('-')]);
        Assert.True(ProgramNames.IsNewOf(Program, one) && ProgramNames.IsOldOf(Program, ProgramNames.Old(one)));
        Assert.False(ProgramNames.IsNewOf("P100", one) || ProgramNames.IsOldOf("P100", ProgramNames.Old(one)));
        Assert.False(ProgramNames.Allows(one) || ProgramNames.Allows(ProgramNames.Old(one)));
    }

    private static async Task SendAsync(ProgramSender sender, byte[] replaces, byte[] bytes)
    {
        try
        {
            await Task.Yield();
            await sender.SendAsync(Program, Hash(replaces), bytes, "1", CancellationToken.None);
        }
        catch (Exception e) when (e is TransportException or ChangedAtMachineException or StoreException)
        {
            // Whatever it says: the machine is what matters.
        }
    }

    private static bool Keeps(string hash) => hash == Hash(Old) || hash == Hash(Mine) || hash == Hash(Next);

    private static bool Same(byte[] one, byte[] other) => one.AsSpan().SequenceEqual(other);

    private static string? Hash(byte[]? bytes) => bytes is null ? null : Convert.ToHexStringLower(SHA256.HashData(bytes));

    /// <summary>How a server changes names, step by step.</summary>
    public enum StepKind
    {
        /// <summary>A folder on Linux.</summary>
        Exchanges,

        /// <summary>SFTP: a second link, then a rename over the first.</summary>
        Links,

        /// <summary>FTP, with a rename over a file.</summary>
        Replaces,

        /// <summary>FTP without one.</summary>
        Refuses,
    }

    /// <summary>Blocks at one step until it is told to go on.</summary>
    private sealed class Freeze(int at) : IDisposable
    {
        private readonly TaskCompletionSource _frozen = new(TaskCreationOptions.RunContinuationsAsynchronously);
        private readonly ManualResetEventSlim _go = new();
        private int _steps;

        public string At { get; private set; } = "";

        public void Do(string doing)
        {
            if (_steps++ != at) return;
            At = doing;
            _frozen.SetResult();
            _go.Wait(TimeSpan.FromMinutes(1));
        }

        public async Task<bool> IsFrozenAsync(Task sending) => await Task.WhenAny(_frozen.Task, sending) == _frozen.Task;

        public void Thaw() => _go.Set();

        public void Dispose() => _go.Dispose();
    }

    /// <summary>One client of a machine's folder in memory. It is frozen before a step of an operation; without the right it begins no
    /// operation.</summary>
    private sealed class SteppedFolder(Dictionary<string, byte[]> files, StepKind kind) : IMachineFolder
    {
        private readonly TaskCompletionSource _frozen = new(TaskCreationOptions.RunContinuationsAsynchronously);
        private readonly TaskCompletionSource _go = new(TaskCreationOptions.RunContinuationsAsynchronously);
        private int _steps;

        public int FreezesAt { get; init; } = -1;

        public bool IsFenced { get; set; }

        public Action<string>? Stepping { get; set; }

        public string Last { get; private set; } = "";

        public string Machine => "mill";

        public async Task<bool> IsFrozenAsync(Task sending) => await Task.WhenAny(_frozen.Task, sending) == _frozen.Task;

        public void Thaw() => _go.SetResult();

        public async Task<IReadOnlyList<string>> ListAsync(CancellationToken cancellation)
        {
            await Step("list");
            return [.. files.Keys.Order(StringComparer.Ordinal)];
        }

        public async Task<byte[]?> ReadAsync(string name, long mostBytes, CancellationToken cancellation)
        {
            await Step("read");
            return files.GetValueOrDefault(name);
        }

        public async Task<byte[]> WriteAsync(string name, ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
        {
            Demand();
            await Step("write");
            files[name] = bytes[..(bytes.Length / 2)].ToArray();
            await Step("write the rest");
            files[name] = bytes.ToArray();
            return files[name];
        }

        public async Task<byte[]> RenameAsync(string from, string to, long mostBytes, CancellationToken cancellation)
        {
            Demand();
            await Step($"take {to}");
            if (kind is StepKind.Refuses && files.ContainsKey(to))
                throw new TransportException(TransportError.CannotReplace, $"{to} is there.");
            Move(from, to);
            await Step("read it back");
            return There(to);
        }

        public async Task<ReplacedProgram?> ReplaceAsync(
            string from, string to, string aside, long mostBytes, CancellationToken cancellation)
        {
            if (kind is StepKind.Replaces or StepKind.Refuses) return null;
            Demand();
            if (kind == StepKind.Links)
            {
                await Step("link");
                if (!files.TryGetValue(to, out var linked) || files.ContainsKey(aside)) return null;
                files[aside] = linked;
                await Step($"take {to}");
                Move(from, to);
            }
            else
            {
                await Step("set aside");
                if (from != aside) Move(from, aside);
                await Step($"take {to}");
                var mine = There(aside);
                if (files.TryGetValue(to, out var other)) files[aside] = other;
                else files.Remove(aside);
                files[to] = mine;
            }

            await Step("read both back");
            return new(There(to), files.GetValueOrDefault(aside));
        }

        public async Task DeleteAsync(string name, CancellationToken cancellation)
        {
            Demand();
            await Step("delete");
            files.Remove(name);
        }

        private void Demand()
        {
            if (IsFenced) throw new StoreException(StoreError.Away, "The right is lost.");
        }

        private byte[] There(string name) =>
            files.GetValueOrDefault(name) ?? throw new TransportException(TransportError.Unknown, $"{name} is not there.");

        private void Move(string from, string to)
        {
            files[to] = There(from);
            files.Remove(from);
        }

        private async Task Step(string name)
        {
            if (_steps++ == FreezesAt)
            {
                Last = name;
                _frozen.SetResult();
                await _go.Task;
            }

            Stepping?.Invoke(name);
        }
    }
}
