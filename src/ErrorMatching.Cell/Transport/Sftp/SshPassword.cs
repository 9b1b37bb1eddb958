using System.Runtime.InteropServices;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>Answers OpenSSH's password prompt with its own program (<c>SSH_ASKPASS</c>) in a private folder. On Linux the program reads a
/// pipe, so that the password is on no disk; on Windows it reads a file that is deleted with the folder.</summary>
internal sealed class SshPassword : IDisposable
{
    private readonly FileStream? _pipe;

    public SshPassword(PrivateFolder folder, string password)
    {
        var (program, answer) = (folder[OperatingSystem.IsWindows() ? "answer.cmd" : "answer"], folder["word"]);
        var bytes = Encoding.UTF8.GetBytes(password + "\n");
        if (OperatingSystem.IsWindows())
        {
            File.WriteAllBytes(answer, bytes);
            File.WriteAllText(program, "@type \"%~dp0word\"\r\n");
        }
        else
        {
            if (MakePipe(Encoding.UTF8.GetBytes(answer + "\0"), 0b110_000_000) != 0)
                throw new IOException($"No pipe could be made in {Path.GetDirectoryName(answer)}: error {Marshal.GetLastPInvokeError()}.");

            // Open for reading and writing, it does not wait for a reader, and buffers what is written until one comes.
            _pipe = new FileStream(answer, FileMode.Open, FileAccess.ReadWrite, FileShare.ReadWrite, bufferSize: 0);
            _pipe.Write(bytes);
            File.WriteAllText(program, "#!/bin/sh\nIFS= read -r word < \"${0%/*}/word\"\nprintf '%s\\n' \"$word\"\n");
            File.SetUnixFileMode(program, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
        }

        Environment = [("SSH_ASKPASS", program), ("SSH_ASKPASS_REQUIRE", "force"), ("DISPLAY", "none")];
    }

    /// <summary>The environment variables for OpenSSH.</summary>
    public IReadOnlyList<(string Name, string Value)> Environment { get; }

    public void Dispose() => _pipe?.Dispose();

    [DllImport("libc", EntryPoint = "mkfifo", SetLastError = true)]
    private static extern int MakePipe(byte[] path, uint mode);
}
