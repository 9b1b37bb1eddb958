using System.Diagnostics;
using System.Globalization;
using System.Text;
using ErrorMatching.Cell;
using ErrorMatching.Json;
using ErrorMatching.Reporting;
using Microsoft.Data.Sqlite;

namespace ErrorMatching.Benchmarks;

/// <summary>Builds the store of a cell after years of work, and times what must stay fast then: start, search and verification. Each
/// correction has the eight steps of one that was sent and released, with the rows, codes and entries that the cell writes. Only the latest
/// have contents of their own; measurement and program of the others are shared by a hundred.</summary>
internal static class MillionCorrections
{
    private const int Machines = 10;
    private const int WithContents = 5000;
    private const int Shared = 100;
    private static readonly DateTimeOffset Begin = new(2020, 1, 1, 0, 0, 0, TimeSpan.Zero);

    /// <summary>Builds a store in a folder, unless it is there, and measures.</summary>
    public static int Run(string folder, string? corrections)
    {
        var count = corrections is null ? 1_000_000 : int.Parse(corrections, CultureInfo.InvariantCulture);
        var settings = new SqliteSettings(Path.Combine(Directory.CreateDirectory(folder).FullName, "cell.db"));
        var keys = Path.Combine(folder, "keys");
        if (!File.Exists(settings.File)) Timed($"build {count} corrections", () => Build(settings, keys, count));
        Console.WriteLine($"file: {new FileInfo(settings.File).Length >> 20} MB");
        var key = AuditKey.Find(keys);
        Timed("start (open, inspect, end of the trail)", () =>
        {
            using var opened = CellStore.Open(settings, TimeProvider.System, key);
            if (new AuditTrail(opened, keys).EndFault() is { } fault) throw new InvalidOperationException(fault.Message);
        });
        using var store = CellStore.Open(settings, TimeProvider.System, key, inspect: false);
        FirstProgram(settings, key, store.Find(count)!);
        foreach (var (name, query) in Queries(count))
        {
            var found = 0;
            Timed(name, () => found = store.Search(query).Count);
            Console.WriteLine($"  {found} found");
        }

        Timed("counts by state", () => store.Corrections.Counts());
        Timed("last sent of a job", () => store.Corrections.LastSent("job-3", null));
        AuditFinding? finding = null;
        Timed("audit verify", () => finding = new AuditTrail(store, keys).Verify());
        Console.WriteLine($"  {finding!.Message} Contents: {finding.Contents}, {finding.ContentBytes >> 20} MB.");
        Console.WriteLine($"  largest working set: {Process.GetCurrentProcess().PeakWorkingSet64 >> 20} MB");
        return finding.Holds ? 0 : 2;
    }

    // The first run on a store reads the whole trail and makes the checkpoint that later runs go on from.
    private static void FirstProgram(SqliteSettings settings, byte[]? key, Correction correction)
    {
        using var store = CellStore.Open(settings, TimeProvider.System, key, inspect: false);
        Timed("first program after a start", () => store.Outside.DemandRecorded(correction));
        Console.WriteLine($"  {store.Outside.WhyWhole?.Sentence ?? "From the checkpoint."} Largest working set: "
            + $"{Process.GetCurrentProcess().PeakWorkingSet64 >> 20} MB, held: {GC.GetTotalMemory(forceFullCollection: true) >> 20} MB");
        Timed("checkpoint", () => store.Outside.KeepCheckpoint(CancellationToken.None));
        Console.WriteLine($"  {store.Read("SELECT length(state) FROM audit_checkpoint", r => r.GetInt64(0))[0]} characters");
        if (store.Outside.WhyWhole is not null) return;
        const int Behind = 20_000;
        Timed($"look at {Behind} entries before the checkpoint", () => store.Outside.LookBehind(Behind));
    }

    private static IEnumerable<(string Name, HistoryQuery Query)> Queries(int count)
    {
        var last = Begin.AddMinutes(2 * count);
        yield return ("search: latest", new());
        yield return ("search: serial", new() { Serial = Serial(count / 2) });
        yield return ("search: part of a serial", new() { Serial = Serial(count / 2)[2..], IsLoose = true });
        yield return ("search: part of a serial that is not there", new() { Serial = "nowhere", IsLoose = true });
        yield return ("search: work order", new() { WorkOrder = "WO-7" });
        yield return ("search: part of a work order", new() { WorkOrder = "o-7", IsLoose = true });
        yield return ("search: a day", new() { From = Begin.AddMinutes(count), To = Begin.AddMinutes(count).AddDays(1) });
        yield return ("search: the first half", new() { To = Begin.AddMinutes(count) });
        yield return ("search: the first half, user", new() { To = Begin.AddMinutes(count), User = "anna" });
        yield return ("search: the first half, nobody", new() { To = Begin.AddMinutes(count), User = "nobody" });
        yield return ("search: the first half, released", new() { To = Begin.AddMinutes(count), State = CorrectionState.Released });
        yield return ("search: the first half, failed", new() { To = Begin.AddMinutes(count), State = CorrectionState.Failed });
        yield return ("search: since the middle", new() { From = Begin.AddMinutes(count) });
        yield return ("search: after all", new() { From = last.AddDays(1) });
        yield return ("search: program name", new() { Program = "O1003.NC" });
        yield return ("search: part of a program name", new() { Program = "1003", IsLoose = true });
        yield return ("search: user", new() { User = "anna" });
        yield return ("search: part of a user", new() { User = "ann", IsLoose = true });
        yield return ("search: nobody", new() { User = "nobody" });
        yield return ("search: part of a user that is not there", new() { User = "nobody", IsLoose = true });
        yield return ("search: part of a work order that is not there", new() { WorkOrder = "nowhere", IsLoose = true });
        yield return ("search: state", new() { State = CorrectionState.Released });
        yield return ("search: machine", new() { Machine = "mill-3" });
        yield return ("search: machine, state, year", new()
        {
            Machine = "mill-3",
            State = CorrectionState.Released,
            From = Begin.AddDays(100),
            To = Begin.AddDays(465),
        });
    }

    private static string Serial(int number) => string.Create(CultureInfo.InvariantCulture, $"SN-{number:0000000}");

    private static void Timed(string name, Action work)
    {
        // Processor time, too: other programs on the same cores slow down the clock's.
        var (began, before) = (Stopwatch.GetTimestamp(), Environment.CpuUsage.TotalTime);
        work();
        Console.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{name}: {Stopwatch.GetElapsedTime(began).TotalSeconds:0.000} s, "
                + $"processor {(Environment.CpuUsage.TotalTime - before).TotalSeconds:0.000} s"));
    }

    private static void Build(SqliteSettings settings, string keys, int count)
    {
        var key = AuditKey.Open(keys);
        AuditHead head;
        using (var store = CellStore.Open(settings, TimeProvider.System, key))
        {
            new UserBook(store, TimeProvider.System).AddFirst("anna", "correct horse battery");
            head = store.AuditHead();
        }

        using var connection = new SqliteConnection($"Data Source={settings.File};Pooling=False");
        connection.Open();
        using (var pragma = connection.CreateCommand())
        {
            pragma.CommandText = "PRAGMA synchronous = OFF; PRAGMA cache_size = -1000000; PRAGMA foreign_keys = OFF";
            pragma.ExecuteNonQuery();
        }

        for (var first = 1; first <= count; first += 50_000)
        {
            using var transaction = connection.BeginTransaction();
            var writer = new Writer(connection, transaction, key, head, count);
            for (var id = first; id < first + 50_000 && id <= count; id++) writer.Correction(id);
            head = writer.Finish();
            transaction.Commit();
        }
    }

    private sealed class Writer(SqliteConnection connection, SqliteTransaction transaction, byte[] key, AuditHead head, int count)
    {
        private readonly Dictionary<string, SqliteCommand> _commands = [];
        private readonly Dictionary<(string Kind, int Group), (string Sha256, int Length)> _texts = [];
        private AuditHead _head = head;

        public void Correction(int id)
        {
            var machine = $"mill-{id % Machines}";
            var group = id > count - WithContents ? -id : id / Shared;
            var (measurement, program, report) = (Text("measurement", group, 20), Text("program", group, 100), Text("report", group, 4000));
            var at = Begin.AddMinutes(2 * id);
            var hash = program.Sha256;
            var c = new Correction(id, CorrectionState.Archived, 1, "cmm", $"part-{id}.csv", at, measurement.Sha256, measurement.Length)
            {
                ChangedAt = at,
            };
            Step(c, null, Recorded.Arrived.With("cmm", c.FileName));
            c = Next(c, CorrectionState.Recognized, Recorded.Of.With("part", $"job-{id % Machines}"), c with
            {
                Job = $"job-{id % Machines}",
                Piece = "part",
                Serial = Serial(id),
                JobWorkOrder = $"WO-{id % 1000}",
                Machine = machine,
                Slot = "A",
                Program = $"O{1000 + (id % Machines)}.NC",
                Identity = ContentHash.Sha256(Encoding.UTF8.GetBytes($"identity {id}")),
            });
            c = Next(c, CorrectionState.Computed, Recorded.DisplacedAt.With(0.1 + (id % 97 * 0.001), Recorded.AtBlock.With("N150")), c with
            {
                ProgramSha256 = hash,
                ReportSha256 = report.Sha256,
                LargestMm = 0.1 + (id % 97 * 0.001),
                SumMm = 0.1 + (id % 97 * 0.001),
            });
            c = Next(c, CorrectionState.Proposed, Recorded.Displaced.With(c.LargestMm), c);
            var (by, basis) = id % 50 == 0 ? ("anna", (Statement)"looks right") : ("cell", Recorded.PolicyWithin.With(0.5));
            c = Next(c, CorrectionState.Approved, basis, c, by);
            c = Next(c, CorrectionState.Uploading, Recorded.SlotEmpty.With(), c, slot: new(machine, "A", id, null, null));
            c = Next(c, CorrectionState.Verified, Recorded.ReadBack.With(), c, slot: new(machine, "A", id, hash, null));
            c = Next(c, CorrectionState.Released, Recorded.MachineWrote.With("A.READY"), c, slot: new(machine, "A", null, hash, null));
            Row(c);
        }

        public AuditHead Finish()
        {
            Run(
                "UPDATE audit_head SET seq = @a, at = @b, hash = @c, seal = @d", _head.Seq, StoredTime.Of(_head.At), _head.Hash,
                _head.Seal);
            foreach (var command in _commands.Values) command.Dispose();
            return _head;
        }

        private Correction Next(
            Correction from, CorrectionState to, Statement basis, Correction with, string by = "cell", SlotHolding? slot = null)
        {
            var after = with with { State = to, Version = from.Version + 1, ChangedAt = from.ChangedAt.AddSeconds(1) };
            Step(after, from.State, basis, by, slot);
            return after;
        }

        private void Step(Correction c, CorrectionState? from, Statement basis, string by = "cell", SlotHolding? slot = null)
        {
            var (to, at) = (CorrectionRow.Word(c.State), StoredTime.Of(c.ChangedAt));
            Run("INSERT INTO step (correction, from_state, to_state, at, who, basis) VALUES (@a, @b, @c, @d, @e, @f)",
                c.Id, from is { } f ? CorrectionRow.Word(f) : null, to, at, by, basis.Text);
            var coded = CorrectionRow.Coded(c);
            var codes = new List<(string, string)> { (coded.Name, coded.Code(key)) };
            if (slot is not null)
            {
                var row = SlotRow.Coded(slot);
                codes.Add((row.Name, row.Code(key)));
                Run("INSERT OR REPLACE INTO slot (machine, slot, correction, program_sha256, previous_sha256, row_code) VALUES (@a, @b, "
                    + "@c, @d, @e, @f)", slot.Machine, slot.Slot, slot.Correction, slot.ProgramSha256, slot.PreviousSha256, codes[1].Item2);
            }

            var subject = from is null ? Recorded.File.With(c.Id, c.MeasurementSha256)
                : c.ProgramSha256 is { } program ? Recorded.Program.With(c.Id, program)
                : Recorded.Correction.With(c.Id);
            var entry = AuditEntry.After(_head.Hash, _head.Seq + 1, c.ChangedAt, by, to, subject, basis, CodedRow.Lines(codes));
            Run("INSERT INTO audit (seq, at, who, what, subject, basis, previous, hash, row_codes) VALUES (@a, @b, @c, @d, @e, @f, @g, "
                + "@h, @i)",
                entry.Seq, at, by, to, subject.Text, basis.Text, entry.Previous, entry.Hash, entry.RowCodes);
            _head = new(entry.Seq, entry.At, entry.Hash, AuditHead.SealOf(key, entry.Seq, entry.Hash));
        }

        private void Row(Correction c) => Run(
            "INSERT INTO correction (id, state, version, arrival, gauge, file_name, arrived_at, changed_at, measurement_sha256, "
                + "measurement_bytes, job, piece, serial, job_work_order, identity, machine, slot, program, program_sha256, report_sha256, "
                + "largest_mm, sum_mm, row_code) "
                + "VALUES (@a, @b, @c, @d, @e, @f, @g, @h, @i, @j, @k, @l, @m, @n, @o, @p, @q, @r, "
                + "@s, @t, @u, @v, @w)",
            c.Id, CorrectionRow.Word(c.State), c.Version, ContentHash.Sha256(Encoding.UTF8.GetBytes($"arrival {c.Id}")), c.Gauge,
            c.FileName, StoredTime.Of(c.ArrivedAt), StoredTime.Of(c.ChangedAt), c.MeasurementSha256, c.MeasurementBytes, c.Job, c.Piece,
            c.Serial, c.JobWorkOrder, c.Identity, c.Machine, c.Slot, c.Program, c.ProgramSha256, c.ReportSha256, c.LargestMm, c.SumMm,
            CorrectionRow.Coded(c).Code(key));

        private (string Sha256, int Length) Text(string kind, int group, int lines)
        {
            if (_texts.TryGetValue((kind, group), out var known)) return known;
            var random = new Random(HashCode.Combine(kind.Length, group));
            var text = new StringBuilder(kind).Append(group).Append('\n');
            for (var i = 0; i < lines; i++)
                text.Append(CultureInfo.InvariantCulture, $"N{i * 10} G1 X{random.Next(100_000) * 0.001:0.000} Y1.5 F500 of {kind}\n");
            var plain = Encoding.UTF8.GetBytes(text.ToString());
            if (_texts.Count > 1000) _texts.Clear();
            known = _texts[(kind, group)] = (ContentHash.Sha256(plain), plain.Length);
            var packed = PackedContent.Of(plain);
            Run("INSERT OR IGNORE INTO content (sha256, bytes, form, length) VALUES (@a, @b, @c, @d)",
                known.Sha256, packed.Bytes, packed.Form, packed.Length);
            return known;
        }

        private void Run(string sql, params object?[] values)
        {
            if (!_commands.TryGetValue(sql, out var command))
            {
                command = connection.CreateCommand();
                (command.CommandText, command.Transaction) = (sql, transaction);
                for (var i = 0; i < values.Length; i++) command.Parameters.Add(new SqliteParameter($"@{(char)('a' + i)}", null));
                _commands.Add(sql, command);
            }

            for (var i = 0; i < values.Length; i++) command.Parameters[i].Value = values[i] ?? DBNull.Value;
            command.ExecuteNonQuery();
        }
    }
}
