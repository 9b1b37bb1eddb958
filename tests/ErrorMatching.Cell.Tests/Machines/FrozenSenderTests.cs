using System.Reflection;
using System.Runtime.Loader;
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

    // The frozen sender goes on in the middle of the standby's work: before each of its steps, and with a change that a person makes in the
    // same moment. Where a name can only be taken over, what is changed between the last look and that is lost on any server.
    [Theory]
    [InlineData(StepKind.Exchanges, false)]
    [InlineData(StepKind.Exchanges, true)]
    [InlineData(StepKind.Links, false)]
    [InlineData(StepKind.Links, true)]
    [InlineData(StepKind.Replaces, false)]
    [InlineData(StepKind.Replaces, true)]
    [InlineData(StepKind.Refuses, false)]
    [InlineData(StepKind.Refuses, true)]
    public async Task A_sender_that_goes_on_between_two_steps_of_the_standby_finds_nothing(StepKind kind, bool isEdited)
    {
        var (frozenSteps, steps, edits) = (0, 0, 0);
        for (var (step, at) = (0, 0); ;)
        {
            Assert.InRange(step, 0, MostSteps);
            Assert.InRange(at, 0, 2 * MostSteps);
            var files = new Dictionary<string, byte[]>(StringComparer.Ordinal) { [Program] = Old };
            var frozen = new SteppedFolder(files, kind) { FreezesAt = step };
            var sending = SendAsync(new ProgramSender(frozen, Keeps), Old, Mine);
            if (!await frozen.IsFrozenAsync(sending))
            {
                await sending;
                break;
            }

            frozen.IsFenced = true;
            var standby = new SteppedFolder(files, kind) { FreezesAt = at };
            var taking = TakeOverAsync(standby);
            if (!await standby.IsFrozenAsync(taking))
            {
                await taking;
                frozen.Thaw();
                await sending;
                (frozenSteps, step, at) = (frozenSteps + 1, step + 1, 0);
                continue;
            }

            var isOpen = kind is StepKind.Links or StepKind.Replaces && (Takes(frozen) || Takes(standby));
            var changes = isEdited && !isOpen && files.ContainsKey(Program);
            if (changes)
            {
                edits++;
                files[Program] = Edited;
            }

            frozen.Thaw();
            await sending;
            standby.Thaw();
            var isSent = await taking;
            var where = $"{kind}: {step}, {frozen.Last}; {at}, {standby.Last}: "
                + string.Join(", ", files.Select(f => $"{f.Key}={Encoding.ASCII.GetString(f.Value)}"));
            if (changes)
            {
                Assert.True(files.Values.Any(f => Same(f, Edited)), where);
            }
            else
            {
                var failure = await Record.ExceptionAsync(
                    () => new ProgramSender(new SteppedFolder(files, kind), Keeps).RecoverAsync(Program, Token));
                Assert.True(failure is null, $"{where}: {failure?.Message}");
                Assert.Equal([Program], files.Keys);

                // The one step that is left takes the program away under the standby's hands. It says so, and people see it.
                if (isSent) Assert.True(Same(files[Program], Next), where);
                else Assert.True(kind == StepKind.Refuses && SetsAside(frozen) && Same(files[Program], Old), where);
            }

            (steps, at) = (steps + 1, at + 1);
        }

        Assert.InRange(frozenSteps, 5, MostSteps);
        Assert.InRange(steps, 5 * frozenSteps, int.MaxValue);
        Assert.Equal(isEdited, edits > steps / 2);

        static bool Takes(SteppedFolder folder) => folder.Last == "take " + Program;

        static bool SetsAside(SteppedFolder folder) => folder.Last.EndsWith(".emold", StringComparison.Ordinal);
    }

    // In the moment of the exchange itself: what was exchanged is compared, and gets its place back, also if the cell keeps it, and a
    // program that was set aside and that the cell keeps would be deleted.
    [Theory]
    [InlineData(StepKind.Exchanges, false)]
    [InlineData(StepKind.Exchanges, true)]
    [InlineData(StepKind.Refuses, false)]
    [InlineData(StepKind.Refuses, true)]
    public async Task A_change_in_the_moment_of_the_exchange_gets_its_name_back(StepKind kind, bool isKept)
    {
        var files = new Dictionary<string, byte[]>(StringComparer.Ordinal) { [Program] = Old };
        var edits = 0;
        var folder = new SteppedFolder(files, kind)
        {
            Stepping = name =>
            {
                if ((kind == StepKind.Exchanges ? name == "take " + Program : name.EndsWith(".emold", StringComparison.Ordinal))
                    && edits++ == 0)
                {
                    files[Program] = Edited;
                }
            },
        };
        var sender = new ProgramSender(folder, h => Keeps(h) || (isKept && h == Hash(Edited)));
        var failure = await Assert.ThrowsAsync<ChangedAtMachineException>(() => sender.SendAsync(Program, Hash(Old), Mine, "1", Token));
        Assert.Equal(Edited, failure.Found);
        Assert.Equal([Program], files.Keys);
        Assert.Equal(Edited, files[Program]);
        Assert.True(edits > 0);
    }

    // A person saves once more in the moment in which an earlier change gets its name back: both are there afterward.
    [Theory]
    [InlineData(StepKind.Exchanges)]
    [InlineData(StepKind.Refuses)]
    public async Task A_change_in_the_moment_in_which_another_gets_its_name_back_is_not_lost(StepKind kind)
    {
        byte[] later = [.. Edited, .. "(later)"u8];
        var files = new Dictionary<string, byte[]>(StringComparer.Ordinal) { [Program] = Mine, [Program + ".emold"] = Edited };
        var edits = 0;
        var folder = new SteppedFolder(files, kind)
        {
            Stepping = name =>
            {
                var isMoment = kind == StepKind.Exchanges ? name == "take " + Program
                    : name.StartsWith($"take {Program}.back-", StringComparison.Ordinal);
                if (isMoment && edits++ == 0)
                    files[Program] = later;
            },
        };
        await Assert.ThrowsAsync<ChangedAtMachineException>(() => new ProgramSender(folder, Keeps).RecoverAsync(Program, Token));
        Assert.True(edits > 0);
        Assert.Equal(Edited, files[Program]);
        Assert.Contains(later, files.Values);
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

    // Two processes, both with their first attempt: the assembly is loaded twice.
    [Fact]
    public void Names_of_two_processes_first_attempts_differ()
    {
        var names = Enumerable.Range(0, 2).Select(_ => FirstName()).ToArray();
        Assert.All(names, n => Assert.EndsWith("-1.emnew", n, StringComparison.Ordinal));
        Assert.All(names, n => Assert.True(ProgramNames.IsNewOf(Program, n)));
        Assert.NotEqual(names[0], names[1]);

        static string FirstName()
        {
            var context = new AssemblyLoadContext(null, isCollectible: true);
            try
            {
                return (string)context.LoadFromAssemblyPath(typeof(ProgramNames).Assembly.Location)
                    .GetType(typeof(ProgramNames).FullName!)!
                    .GetMethod(nameof(ProgramNames.New), BindingFlags.NonPublic | BindingFlags.Static)!
                    .Invoke(null, [Program, "17"])!;
            }
            finally
            {
                context.Unload();
            }
        }
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

    // What a process does that takes the slot over: true once the program is sent. What a person changed is left to people.
    private static async Task<bool> TakeOverAsync(SteppedFolder folder)
    {
        var sender = new ProgramSender(folder, Keeps);
        for (var tries = 0; tries < 3; tries++)
        {
            try
            {
                await Task.Yield();
                await sender.RecoverAsync(Program, CancellationToken.None);
                var found = await sender.CurrentAsync(Program, CancellationToken.None);
                if (found is null || Keeps(Hash(found)!))
                    await sender.SendAsync(Program, Hash(found), Next, "2", CancellationToken.None);
                return true;
            }
            catch (ChangedAtMachineException)
            {
                return false;
            }
            catch (TransportException)
            {
                // As the cell does, it looks again from the start.
            }
        }

        throw new InvalidOperationException("Three tries were not enough.");
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
