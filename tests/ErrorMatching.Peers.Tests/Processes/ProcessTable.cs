using System.Globalization;
using System.Text;

namespace ErrorMatching.Peers.Tests;

/// <summary>What Linux tells of the processes and of the TCP sockets of this computer, as proc(5) has it.</summary>
internal static class ProcessTable
{
    private const string Established = "01";
    private const string Listening = "0A";

    /// <summary>The processes that another one started, and those that they started.</summary>
    public static List<(int Id, string Name, int Parent)> Descendants(int of)
    {
        var all = All();
        var found = new List<(int Id, string Name, int Parent)>();
        void Add(int parent)
        {
            foreach (var process in all.Where(p => p.Parent == parent))
            {
                found.Add(process);
                Add(process.Id);
            }
        }

        Add(of);
        return found;
    }

    /// <summary>The descendants of this process that are connected to a loopback port, and those between it and them.</summary>
    public static List<(int Id, string Name, int Parent)> ConnectedTo(int port)
    {
        var sockets = Sockets(Established, port, isRemote: true);
        var descendants = Descendants(Environment.ProcessId);
        var found = descendants.Where(p => Holds(p.Id, sockets)).ToList();
        for (var i = 0; i < found.Count; i++)
            found.AddRange(descendants.Where(p => p.Id == found[i].Parent && !found.Contains(p)));
        return found;
    }

    /// <summary>True if a process listens at a loopback port, and nobody in its place.</summary>
    /// <remarks>What another user's process has open is shown to the privileged alone. To others a server that goes on while somebody
    /// listens at its port is the one that listens.</remarks>
    public static bool Listens(int id, int port)
    {
        var sockets = Sockets(Listening, port, isRemote: false);
        return sockets.Count > 0 && (Open(id) is not { Count: > 0 } open || open.Any(sockets.Contains));
    }

    /// <summary>True unless the process has ended.</summary>
    public static bool IsAlive(int id)
    {
        var stat = Read(id, "stat");
        return stat.Length > 0 && AfterName(stat)[0] is not ("Z" or "X");
    }

    /// <summary>Waits until processes have ended; false if they have not within two minutes.</summary>
    public static async Task<bool> EndAsync(IEnumerable<int> ids)
    {
        var left = ids.ToList();
        for (var tries = 0; tries < 12_000; tries++)
        {
            left.RemoveAll(id => !IsAlive(id));
            if (left.Count == 0)
                return true;
            await Task.Delay(10);
        }

        return false;
    }

    /// <summary>A file of a process's folder; empty if the process has ended, as it may while it is looked at.</summary>
    public static string Read(int id, string what)
    {
        try
        {
            return Encoding.UTF8.GetString(File.ReadAllBytes($"/proc/{id}/{what}"));
        }
        catch (IOException)
        {
            return "";
        }
    }

    /// <summary>What a process has open: the paths of files, and words such as socket:[17].</summary>
    public static List<string> Open(int id)
    {
        var open = new List<string>();
        try
        {
            foreach (var link in Directory.GetFiles($"/proc/{id}/fd"))
            {
                if (new FileInfo(link).LinkTarget is { } target)
                    open.Add(target);
            }
        }
        catch (IOException)
        {
        }

        return open;
    }

    private static bool Holds(int id, HashSet<string> sockets) => sockets.Count > 0 && Open(id).Any(sockets.Contains);

    // Columns: number, local address, remote address, state, ..., the tenth is the inode. Addresses are hexadecimal, "0100007F:1F90".
    private static HashSet<string> Sockets(string state, int port, bool isRemote)
    {
        var end = ":" + port.ToString("X4", CultureInfo.InvariantCulture);
        return File.ReadLines("/proc/net/tcp").Skip(1)
            .Select(line => line.Split(' ', StringSplitOptions.RemoveEmptyEntries))
            .Where(c => c[3] == state && c[isRemote ? 2 : 1].EndsWith(end, StringComparison.Ordinal))
            .Select(c => $"socket:[{c[9]}]")
            .ToHashSet(StringComparer.Ordinal);
    }

    private static List<(int Id, string Name, int Parent)> All()
    {
        var all = new List<(int Id, string Name, int Parent)>();
        foreach (var folder in Directory.GetDirectories("/proc"))
        {
            if (!int.TryParse(Path.GetFileName(folder), NumberStyles.None, CultureInfo.InvariantCulture, out var id))
                continue;
            var stat = Read(id, "stat");
            if (stat.Length > 0)
                all.Add(
                    (
                        id,
                        stat[(stat.IndexOf('(', StringComparison.Ordinal) + 1)..stat.LastIndexOf(')')],
                        int.Parse(AfterName(stat)[1], CultureInfo.InvariantCulture)));
        }

        return all;
    }

    // State, parent, ...: a name may hold blanks and parentheses.
    private static string[] AfterName(string stat) => stat[(stat.LastIndexOf(')') + 2)..].Split(' ');
}
