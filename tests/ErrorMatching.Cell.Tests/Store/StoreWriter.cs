using System.Diagnostics;
using System.Globalization;
using System.Runtime.CompilerServices;
using System.Text;

namespace ErrorMatching.Cell.Tests;

/// <summary>This program a second time, as another process that works with a store: it says on its output what was acknowledged, and may be
/// killed at any instant. It does not outlive its test.</summary>
internal sealed class StoreWriter : IDisposable
{
    private const string Task = "ERRORMATCH_TEST_STORE_TASK";
    private const string File = "ERRORMATCH_TEST_STORE_FILE";
    private readonly Process _process;

    private StoreWriter(Process process) => _process = process;

    /// <summary>What it says.</summary>
    public StreamReader Output => _process.StandardOutput;

    /// <summary>What it is told.</summary>
    public StreamWriter Input => _process.StandardInput;

    /// <summary>Starts the other process.</summary>
    /// <param name="task">What it does: the name of one of the methods below.</param>
    /// <param name="file">The store.</param>
    /// <param name="before">A program and arguments that start it; nothing for none.</param>
    public static StoreWriter Start(string task, string file, params string[] before)
    {
        var program = Path.Combine(
            AppContext.BaseDirectory, OperatingSystem.IsWindows() ? "ErrorMatching.Cell.Tests.exe" : "ErrorMatching.Cell.Tests");
        string[] all = [.. before, program];
        var start = new ProcessStartInfo(all[0], all[1..])
        {
            UseShellExecute = false,
            RedirectStandardOutput = true,
            RedirectStandardInput = true
        };
        start.Environment[Task] = task;
        start.Environment[File] = file;
        return new(Process.Start(start)!);
    }

    /// <summary>Ends it at once.</summary>
    public void Kill()
    {
        _process.Kill(entireProcessTree: true);
        _process.WaitForExit();
    }

    /// <summary>Waits until it has ended by itself.</summary>
    public void WaitForExit() => _process.WaitForExit();

    /// <summary>Ends it, should it still run.</summary>
    public void Dispose()
    {
        Kill();
        _process.Dispose();
    }

    // Before the tests of this program begin, of which there are to be none then.
#pragma warning disable CA2255 // A program, not a library: this is the one place before its entry.
    [ModuleInitializer]
#pragma warning restore CA2255
    internal static void RunTask()
    {
        var task = Environment.GetEnvironmentVariable(Task);
        if (task is null) return;
        var settings = new SqliteSettings(Environment.GetEnvironmentVariable(File)!);
        switch (task)
        {
            case "write":
                Write(settings);
                break;
            case "take-turns":
                TakeTurns(settings);
                break;
            case "hold":
                Hold(settings);
                break;
            case "fill":
                Fill(settings);
                break;
            case "read-only":
                ReadOnly(settings);
                break;
        }

        Environment.Exit(0);
    }

    // Takes steps until it is killed.
    private static void Write(SqliteSettings settings)
    {
        using var store = CellStore.Open(settings, TimeProvider.System);
        for (var i = 0; ; i++)
        {
            var key = $"{Environment.ProcessId}-{i}";
            var correction = store.Archive(new Arrival("gauge", key, key, Encoding.UTF8.GetBytes(key))).Correction;
            Report(correction);
            correction = store.Step(correction, CorrectionState.Recognized, "cell", "by name", c => c with { Identity = key });
            Report(correction);
            var program = new byte[20_000];
            Random.Shared.NextBytes(program);
            correction = store.Step(correction, CorrectionState.Computed, "cell", "computed", contents: [program]);
            Report(correction);
        }
    }

    // Takes a step for each line that it is told.
    private static void TakeTurns(SqliteSettings settings)
    {
        using var store = CellStore.Open(settings, TimeProvider.System);
        while (Console.In.ReadLine() is { } key)
        {
            Report(store.Archive(new Arrival("gauge", key, key, Encoding.UTF8.GetBytes(key))).Correction);
        }
    }

    // Keeps the store in a change, and a slot, until its input ends.
    private static void Hold(SqliteSettings settings)
    {
        using var store = CellStore.Open(settings, TimeProvider.System);
        using var slot = store.TryLockSlot("mill", "1");
        store.Write(_ =>
        {
            Console.Out.WriteLine("held");
            return Console.In.ReadLine();
        });
    }

    // On a disk that becomes full and gets room again.
    private static void Fill(SqliteSettings settings)
    {
        var ballast = settings.File + ".ballast";
        System.IO.File.WriteAllBytes(ballast, new byte[200_000]);
        using (var store = CellStore.Open(settings, TimeProvider.System))
        {
            var written = new List<Correction>();
            while (true)
            {
                try
                {
                    var bytes = new byte[10_000];
                    Random.Shared.NextBytes(bytes);
                    written.Add(store.Archive(new Arrival("gauge", "file", Guid.NewGuid().ToString(), bytes)).Correction);
                }
                catch (StoreException failure)
                {
                    Console.Out.WriteLine($"{failure.Error} after some: {written.Count > 5}");
                    Console.Out.WriteLine(failure.Message[failure.Message.IndexOf("Make room", StringComparison.Ordinal)..]);
                    break;
                }
            }

            Console.Out.WriteLine(KeysOn(settings.File + ".rest"));

            Console.Out.WriteLine(
                $"all there: {store.Corrections.InState(CorrectionState.Archived).SequenceEqual(written)}, "
                    + $"chain: {store.VerifyAudit() is null}");
            System.IO.File.Delete(ballast);
            written.Add(store.Archive(new Arrival("gauge", "file", "after", "after"u8.ToArray())).Correction);
            Console.Out.WriteLine(
                $"all there: {store.Corrections.InState(CorrectionState.Archived).SequenceEqual(written)}, "
                    + $"chain: {store.VerifyAudit() is null}");
        }

        using var again = CellStore.Open(settings, TimeProvider.System);
        Console.Out.WriteLine($"opened again, chain: {again.VerifyAudit() is null}");
    }

    // What is said of keys that the disk has no room for.
    private static string KeysOn(string rest)
    {
        try
        {
            using (var last = new FileStream(rest, FileMode.CreateNew, FileAccess.Write, FileShare.None, bufferSize: 0))
            {
                for (var part = new byte[1024]; ;) last.Write(part);
            }
        }
        catch (IOException)
        {
            // Now there is no room at all.
        }

        try
        {
            AuditKey.Open(Path.Combine(Path.GetDirectoryName(rest)!, "keys"));
            return "there was room";
        }
        catch (PeopleException e)
        {
            return e.Message[e.Message.IndexOf("Make room", StringComparison.Ordinal)..];
        }
        finally
        {
            System.IO.File.Delete(rest);
        }
    }

    // On a disk that is mounted read-only while no cell runs.
    private static void ReadOnly(SqliteSettings settings)
    {
        var folder = Path.GetDirectoryName(settings.File)!;
        var left = Path.Combine(Directory.CreateDirectory(Path.Combine(folder, "left")).FullName, "cell.db");
        var key = AuditKey.Open(Path.Combine(folder, "keys"));
        using (var store = CellStore.Open(settings, TimeProvider.System, key))
        {
            // What a process leaves that ends at once: its log and the index of that.
            store.Audit("anna", "signed-in", "password");
            foreach (var end in new[] { "", "-wal", "-shm" }) System.IO.File.Copy(settings.File + end, left + end);
        }

        Mount("ro");
        Try();
        Look(settings.File);
        Look(left);
        Mount("rw");
        Try();

        void Mount(string how)
        {
            using var mount = Process.Start("mount", ["-o", $"remount,{how}", folder]);
            mount.WaitForExit();
        }

        void Look(string file)
        {
            using var store = CellStore.OpenToRead(new SqliteSettings(file), TimeProvider.System, key);
            using var csv = new StringWriter();
            var (finding, written) = (new AuditTrail(store, Path.Combine(folder, "keys")).Verify(),
                new AuditTrail(store, folder).Export(csv));
            var refused = Assert.Throws<StoreException>(() => store.Audit("anna", "signed-in", "password")).Error;
            Console.Out.WriteLine(string.Create(
                CultureInfo.InvariantCulture, $"read {finding.Entries}, whole: {finding.Holds}, exported {written}, changes: {refused}"));
        }

        void Try()
        {
            try
            {
                using var store = CellStore.Open(settings, TimeProvider.System, key);
                store.Audit("anna", "signed-in", "password");
                Console.Out.WriteLine($"kept {store.ChangeCount().ToString(CultureInfo.InvariantCulture)}");
            }
            catch (StoreException failure)
            {
                Console.Out.WriteLine(failure.Error);
            }
        }
    }

    private static void Report(Correction correction)
    {
        Console.Out.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{correction.Id} {correction.Version}"));
        Console.Out.Flush();
    }
}
