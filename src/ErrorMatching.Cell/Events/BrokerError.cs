namespace ErrorMatching.Cell;

/// <summary>Why a broker does not take messages.</summary>
public enum BrokerError
{
    /// <summary>It does not respond, or the connection broke.</summary>
    Away,

    /// <summary>It refused the login.</summary>
    Login,

    /// <summary>Its certificate is not the trusted one.</summary>
    WrongServer,

    /// <summary>It does not accept the topic or the message.</summary>
    Denied,

    /// <summary>It does not speak MQTT 5, or not with quality of service 2.</summary>
    Unsupported,

    /// <summary>The file of the password or of the authorities' certificates cannot be used.</summary>
    Secret,
}

/// <summary>A broker that does not take messages.</summary>
/// <param name="error">Why.</param>
/// <param name="message">A sentence for a setter: broker, what was being done, the reply, what to do next. No secrets.</param>
/// <param name="cause">The underlying error; null if there is none.</param>
internal sealed class BrokerException(BrokerError error, string message, Exception? cause = null) : Exception(message, cause)
{
    /// <summary>Why.</summary>
    public BrokerError Error => error;

    /// <summary>Creates the exception.</summary>
    /// <param name="error">Why.</param>
    /// <param name="broker">The broker.</param>
    /// <param name="doing">What was being done, such as <c>connecting</c>.</param>
    /// <param name="answer">The reply; no secrets.</param>
    /// <param name="cause">The underlying error; null if there is none.</param>
    public static BrokerException Of(BrokerError error, EventSettings broker, string doing, string answer, Exception? cause = null) =>
        new(error, $"{broker.Address}: {doing} failed: {answer.Trim().TrimEnd('.')}. {Next(error)}", cause);

    private static string Next(BrokerError error) => error switch
    {
        BrokerError.Away =>
            "Check that the broker runs, the network, and host and port in the cell's configuration. The steps wait in the store.",
        BrokerError.Login => "Check the user in the cell's configuration and the password in its file.",
        BrokerError.WrongServer =>
            "Nothing was sent, not even the password. If the broker's certificate was renewed on purpose, let its administrator tell you "
                + "the new one; else somebody may stand between.",
        BrokerError.Denied => "Let the broker's administrator allow this user to publish to this topic.",
        BrokerError.Unsupported => "The broker must speak MQTT 5 with quality of service 2.",
        _ => "Put the file right; the cell goes on by itself.",
    };
}
