// Another way to a machine is one class, IMachineFolder. The sender on top of it is the cell's: the machine has the old program or the
// new one, whole, and a change that somebody made at the control is not overwritten.
using System.Security.Cryptography;
using ErrorMatching.Cell;
using OwnTransport;

var folder = Directory.CreateTempSubdirectory("own-transport-");
var machine = new ArchiveFolder("mill-2", Path.Combine(folder.FullName, "programs.zip"));
var kept = new HashSet<string>();
var sender = new ProgramSender(machine, kept.Contains);
try
{
    var original = "N10 G1 X10. F300\n"u8.ToArray();
    await machine.WriteAsync("O1.NC", original, CancellationToken.None);

    // What is at the machine must be stored elsewhere before it is replaced.
    kept.Add(Hash(original));
    await sender.SendAsync("O1.NC", Hash(original), "N10 G1 X10.02 F300\n"u8.ToArray(), "example", CancellationToken.None);
    Console.WriteLine($"sent: {string.Join(", ", await machine.ListAsync(CancellationToken.None))}");

    await machine.WriteAsync("O1.NC", "N10 G1 X11. F300\n"u8.ToArray(), CancellationToken.None);
    await sender.SendAsync("O1.NC", Hash(original), "N10 G1 X10.03 F300\n"u8.ToArray(), "example", CancellationToken.None);
}
catch (ChangedAtMachineException e)
{
    Console.WriteLine($"not sent: {e.Message}");
}
finally
{
    folder.Delete(recursive: true);
}

static string Hash(byte[] bytes) => Convert.ToHexStringLower(SHA256.HashData(bytes));
