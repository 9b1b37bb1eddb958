using System.Text;
using ErrorMatching.Json;
using Renci.SshNet;
using Renci.SshNet.Common;

namespace ErrorMatching.Cell;

/// <summary>How a login shows who it is: by a key, or by a password that the server asks for in either of the two ways.</summary>
internal sealed class SftpSignIn : IDisposable
{
    private const int MostKey = 64 << 10;
    private readonly PrivateKeyFile? _key;

    /// <summary>Prepares a login by key.</summary>
    /// <param name="user">The login's name.</param>
    /// <param name="keyFile">The private key.</param>
    /// <exception cref="SftpSignInException">The key cannot be used.</exception>
    public SftpSignIn(string user, string keyFile)
    {
        _key = Load(keyFile);
        Methods = [new PrivateKeyAuthenticationMethod(user, _key)];
    }

    /// <summary>Prepares a login by password.</summary>
    /// <param name="user">The login's name.</param>
    /// <param name="password">The password; null for an empty one.</param>
    public SftpSignIn(string user, Func<string?> password)
    {
        var word = password() ?? "";
        var asked = new KeyboardInteractiveAuthenticationMethod(user);
        var isAnswered = false;
        asked.AuthenticationPrompt += (_, question) =>
        {
            foreach (var prompt in question.Prompts)
            {
                // A second hidden question is for something else, such as a code, and a shown one is not for a password.
                if (isAnswered || prompt.IsEchoed)
                    throw new SshAuthenticationException($"the server asks for more than a password: \"{ServerWords.Of(prompt.Request)}\"");
                (prompt.Response, isAnswered) = (word, true);
            }
        };
        Methods = [new PasswordAuthenticationMethod(user, Encoding.UTF8.GetBytes(word)), asked];
    }

    /// <summary>The ways, in the order in which they are tried.</summary>
    public AuthenticationMethod[] Methods { get; }

    public void Dispose()
    {
        foreach (var method in Methods)
            method.Dispose();
        _key?.Dispose();
    }

    // Like OpenSSH's own programs, which refuse a key of the user's that other users can read.
    private static PrivateKeyFile Load(string file)
    {
        try
        {
            if (OperatingSystem.IsLinux()
                && (File.GetUnixFileMode(file) & (UnixFileMode)0b111_111) != UnixFileMode.None
                && LinuxCalls.IsOwn(file))
            {
                throw new SftpSignInException($"other users may read the key {file}: take their rights to it away (chmod 600)");
            }

            using var stream = SharedFile.OpenRead(file);
            if (stream.Length > MostKey)
                throw new SftpSignInException($"{file} has {stream.Length} bytes, a private key has at most {MostKey}");
            return new PrivateKeyFile(stream);
        }
        catch (SshPassPhraseNullOrEmptyException)
        {
            throw new SftpSignInException($"the key {file} has a passphrase, which nobody is there to type: make one without");
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new SftpSignInException($"the key {file} cannot be read: {e.Message}");
        }
        catch (Exception e) when (e is not SftpSignInException)
        {
            // What the library throws at a damaged file has many types. Its text may repeat some of the key.
            throw new SftpSignInException($"{file} is no private key that can be used ({e.GetType().Name})");
        }
    }
}

/// <summary>A key that cannot be used for a login.</summary>
internal sealed class SftpSignInException(string message) : Exception(message);
