using System.Globalization;

namespace ErrorMatching.Hmi.Tests;

/// <summary>The segments of shared memory that the system has.</summary>
internal static class SharedMemory
{
    /// <summary>Those that a process created: mode bits, and by how many processes they are attached.</summary>
    public static IReadOnlyList<(int Mode, int Attached)> Of(int process)
    {
        // key shmid perms size cpid lpid nattch ..., where perms is octal.
        return
        [
            .. File.ReadLines("/proc/sysvipc/shm")
                .Skip(1)
                .Select(l => l.Split(' ', StringSplitOptions.RemoveEmptyEntries))
                .Where(f => int.Parse(f[4], CultureInfo.InvariantCulture) == process)
                .Select(f => (Convert.ToInt32(f[2], 8), int.Parse(f[6], CultureInfo.InvariantCulture)))
        ];
    }
}
